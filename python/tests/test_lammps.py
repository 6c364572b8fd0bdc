# SPDX-License-Identifier: GPL-3.0-or-later
"""A packing in LAMMPS' memory. The object here has the members of LAMMPS' that are read; tests/peer asks LAMMPS."""

import ctypes

import granum
import numpy as np
import pytest

LOCAL, VECTOR, ARRAY, ROWS, COLUMNS = 2, 1, 2, 4, 5


class Numpy:
    """lmp.numpy"""

    def __init__(self, lmp):
        self.lmp = lmp

    def extract_atom(self, name):
        return self.lmp.atoms.get(name)

    def extract_compute(self, name, style, kind):
        assert (style, kind) == (LOCAL, ARRAY) and self.lmp.computes[name].size > 0
        return self.lmp.computes[name]


class Lammps:
    """Three spheres, of which the first and the last touch through a face, the highest id first; behind them two ghosts."""

    def __init__(self):
        self.atoms = {
            "id": np.array([7, 5, 2, 2, 7], dtype=np.int32),
            "type": np.array([1, 2, 1, 1, 1], dtype=np.int32),
            "x": np.array([[3.3, 1, 1], [1.1, 1, 1], [0.2, 1, 1], [4.2, 1, 1], [-0.7, 1, 1]]),
            "radius": np.full(5, 0.5),
        }
        # Forces on the first of a pair: 5 is pushed by 2 along +x, 7 by 2 along -x, through the face.
        self.computes = {
            "ids": np.array([[5.0, 2.0], [7.0, 2.0]]),
            "forces": np.array([[0.9, 2, 2, 0, 0, 0, 0.5, 0, 0.5], [0.9, 3, -3, 0, 0, 0, 0, 0.25, 0.25]]),
            "distance": np.array([0.9, 0.9]),
        }
        self.processes, self.units, self.numpy = 1, "si", Numpy(self)

    def extract_setting(self, name):
        return {"world_size": self.processes, "nlocal": 3}[name]

    def extract_global(self, name):
        return {"units": self.units, "ntimestep": 12}[name]

    def extract_box(self):
        return [0.0, -1.0, 0.0], [4.0, 4.0, 6.0], 0.5, 0.3, 0.2, [1, 1, 0], 1  # xy, yz, xz

    def has_id(self, category, name):
        return category == "compute" and (name in self.computes or name == "pressure")

    def extract_compute(self, name, style, kind):
        assert style == LOCAL
        if name == "pressure":
            raise ValueError("NULL pointer access")
        values = self.computes[name]
        if kind == VECTOR:
            return values.ctypes.data_as(ctypes.POINTER(ctypes.c_double))
        return {ROWS: len(values), COLUMNS: 0 if values.ndim == 1 else values.shape[1]}[kind]


@pytest.fixture
def lmp():
    return Lammps()


def test_grains_cell_and_contacts(lmp):
    packing = granum.from_lammps(lmp, contacts=("ids", "forces"))
    assert packing.id.tolist() == [2, 5, 7] and packing.type.tolist() == [1, 2, 1]
    assert packing.position[:, 0].tolist() == [0.2, 1.1, 3.3]
    assert packing.periodic == (True, True, False) and packing.step == 12
    np.testing.assert_array_equal(packing.cell, [[4, 0.5, 0.2], [0, 5, 0.3], [0, 0, 6]])
    contacts = packing.contacts
    assert contacts.i.tolist() == [0, 0] and contacts.j.tolist() == [1, 2]
    np.testing.assert_allclose(contacts.branch[:, 0], [0.9, -0.9])
    assert contacts.normal_force.tolist() == [2, 3]
    # Exerted by i on j: the first of each pair is the later grain here, and forces are those on it.
    assert contacts.tangential_force.tolist() == [[0, 0.5, 0], [0, 0, 0.25]]


def test_the_packing_outlives_lammps(lmp):
    packing = granum.from_lammps(lmp, contacts=("ids", "forces"))
    lmp.atoms["x"][:] = np.nan
    assert np.isfinite(packing.position).all()


def test_columns_are_given_where_values_do_not_determine_them(lmp):
    columns = {"id1": "c_ids[1]", "id2": "c_ids[2]", "force": "c_forces[2]"}
    packing = granum.from_lammps(lmp, contacts=("ids", "forces"), columns=columns)
    assert packing.contacts.normal_force.tolist() == [2, 3]
    assert packing.notes


def test_a_compute_of_one_column_is_a_vector(lmp):
    packing = granum.from_lammps(lmp, contacts=["ids", "distance"])
    assert len(packing.contacts) == 2
    assert packing.notes


def test_no_rows_are_no_contacts(lmp):
    lmp.computes = {name: values[:0] for name, values in lmp.computes.items()}
    assert len(granum.from_lammps(lmp, contacts=("ids", "forces")).contacts) == 0


def test_without_contacts_those_of_overlaps_are_taken(lmp, sphere):
    packing = granum.from_lammps(lmp)
    assert len(packing.contacts) == 0
    assert granum.measure(packing, law=sphere, network=False).counts.contacts == 2


def test_other_units_become_si(lmp):
    lmp.units = "cgs"
    packing = granum.from_lammps(lmp, contacts=("ids", "forces"))
    np.testing.assert_allclose(packing.radius, 0.5e-2)
    np.testing.assert_allclose(packing.contacts.normal_force, [2e-5, 3e-5])


@pytest.mark.parametrize(
    "change, contacts, message",
    [
        (lambda lmp: setattr(lmp, "processes", 4), (), "4"),
        (lambda lmp: lmp.atoms.pop("radius"), (), "radius"),
        (lambda lmp: setattr(lmp, "units", "metal"), (), "metal"),
        (lambda lmp: None, "nothing", "nothing"),
        (lambda lmp: None, "pressure", "pressure"),
        (lambda lmp: lmp.computes.update(ids=np.array([[5.0, 2.0]])), ("ids", "forces"), "ids.*1.*forces.*2"),
        (lambda lmp: lmp.computes["ids"].__setitem__((1, 0), 9.0), ("ids", "forces"), r"contacts"),
        (lambda lmp: None, ("forces",), "forces"),
    ],
)


def test_errors_are_reported(lmp, change, contacts, message):
    change(lmp)
    with pytest.raises(granum.InvalidArgument, match=message):
        granum.from_lammps(lmp, contacts=contacts)
