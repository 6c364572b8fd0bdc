# SPDX-License-Identifier: GPL-3.0-or-later
"""Wrote data/vtk_*.vtu and data/vtk_*.vtp by VTK 9.1 (Debian: python3-vtk9):  write_vtk_chain.py <folder>

The chain of data/README.md with the arrays of YADE's VTKRecorder, in each way in which VTK packs arrays.
"""

import os
import sys

import vtk

CENTRES = [(1e-3, 2e-3, 2e-3), (1.9999e-3, 2e-3, 2e-3), (1.9999e-3, 2e-3, 2.9998e-3)]
NONE = (float("nan"),) * 3  # a body that was deleted


def array(name, values):
    numbers = vtk.vtkDoubleArray()
    numbers.SetName(name)
    for value in values:
        numbers.InsertNextValue(value)
    return numbers


def points(coordinates):
    out = vtk.vtkPoints()  # of single precision, as YADE's
    for point in coordinates:
        out.InsertNextPoint(point)
    return out


def grains():
    grid = vtk.vtkUnstructuredGrid()
    cells = vtk.vtkCellArray()
    for k in range(3):
        cells.InsertNextCell(1)
        cells.InsertCellPoint(k)
    grid.SetPoints(points(CENTRES))
    grid.SetCells(vtk.VTK_VERTEX, cells)
    for name, values in (("radii", [5e-4] * 3), ("id", [0, 2, 4]), ("mass", [1e-6] * 3)):
        grid.GetPointData().AddArray(array(name, values))
    return grid


def contacts():
    lines = vtk.vtkPolyData()
    cells = vtk.vtkCellArray()
    for ends in ((0, 2), (2, 4)):
        cells.InsertNextCell(2)
        for end in ends:
            cells.InsertCellPoint(end)
    lines.SetPoints(points([CENTRES[0], NONE, CENTRES[1], (0, 0, 0), CENTRES[2]]))
    lines.SetLines(cells)
    lines.GetCellData().AddArray(array("forceN", [0.0235294118, 0.0665512265]))
    return lines


def write(name, data, *settings):
    poly = data.IsA("vtkPolyData")
    writer = vtk.vtkXMLPolyDataWriter() if poly else vtk.vtkXMLUnstructuredGridWriter()
    writer.SetInputData(data)
    writer.SetFileName(os.path.join(sys.argv[1], name))
    for setting in settings:
        setting(writer)
    writer.Write()


Writer = vtk.vtkXMLWriter
bare = Writer.SetCompressorTypeToNone
write("vtk_appended.vtu", grains())  # as YADE does: appended, base64, zlib
write("vtk_packed.vtu", grains(), Writer.SetDataModeToBinary)
write("vtk_raw.vtu", grains(), lambda w: w.SetEncodeAppendedData(0), bare, Writer.SetHeaderTypeToUInt64)
write("vtk_blocks.vtu", grains(), lambda w: w.SetEncodeAppendedData(0), lambda w: w.SetBlockSize(16))
write("vtk_big.vtu", grains(), Writer.SetDataModeToBinary, bare, Writer.SetByteOrderToBigEndian)
write("vtk_appended.vtp", contacts())
