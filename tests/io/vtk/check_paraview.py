# SPDX-License-Identifier: GPL-3.0-or-later
# What VTK's own readers (Debian: python3-vtk9) make of the files that write_paraview_sample wrote.
import os
import sys

import vtk

folder = sys.argv[1]


def read(reader, name):
    errors = []
    reader.AddObserver("ErrorEvent", lambda *_: errors.append(name))
    reader.SetFileName(os.path.join(folder, name))
    reader.Update()
    assert not errors, f"VTK refuses {name}"
    return reader.GetOutput()


def values(attributes, name):
    array = attributes.GetArray(name)
    return [array.GetTuple(k) for k in range(array.GetNumberOfTuples())]


grains = read(vtk.vtkXMLUnstructuredGridReader(), "grains.vtu")
assert grains.GetNumberOfPoints() == 3 and grains.GetNumberOfCells() == 3
assert grains.GetCell(2).GetCellType() == vtk.VTK_VERTEX
assert grains.GetPoint(1) == (0.0019, 0.002, 0.002)
assert values(grains.GetPointData(), "radius") == [(0.5e-3,), (0.5e-3,), (0.25e-3,)]
assert values(grains.GetPointData(), "contacts") == [(2,), (1,), (1,)]
assert values(grains.GetFieldData(), "TimeValue") == [(0.25,)]
assert values(grains.GetFieldData(), "cell") == [(4e-3, 0, 0, 0, 4e-3, 0, 0, 0, 4e-3)]

contacts = read(vtk.vtkXMLPolyDataReader(), "contacts.vtp")
assert contacts.GetNumberOfLines() == 3 and contacts.GetNumberOfPoints() == 6
assert contacts.GetCell(1).GetPoints().GetPoint(1) == (0.001, 0.002, 0.0027)
assert values(contacts.GetCellData(), "normal_force") == [(2,), (1 / 3,), (3,)]
assert values(contacts.GetCellData(), "tangential_force") == [(0, 0, 0), (0.1, -0.2, 0), (0, 0, 0)]
assert values(contacts.GetCellData(), "grains") == [(0, 1), (0, 2), (2, 2)]
assert values(contacts.GetCellData(), "wall") == [(-1,), (-1,), (5,)]
