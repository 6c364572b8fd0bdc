# SPDX-License-Identifier: GPL-3.0-or-later
"""Ids of arrays, files for ParaView, patterns of names, several sands in a call, and data sets of xarray."""

import granum
import numpy as np
import pytest

LAW = granum.sphere(shear_modulus=30e9, poisson_ratio=0.15, radius=5e-4)
SAND = dict(law=LAW, radius=2e-4, grain_density=2650.0)
THREE = dict(position=[[0, 0, 0], [0.9e-3, 0, 0], [1.8e-3, 0, 0]], radius=0.5e-3, cell=[4e-3] * 3)
PAIRS = dict(contacts=[[0, 1], [2, 1]], normal_force=[1.0, 2.0])


# ---- ids


def test_ids_are_kept_in_the_order_of_the_arrays():
    packing = granum.packing(**THREE, **PAIRS, id=[30, 10, 20])
    assert packing.id.tolist() == [30, 10, 20]
    assert packing.contacts.i.tolist() == [0, 1] and packing.contacts.normal_force.tolist() == [1.0, 2.0]
    assert granum.packing(**THREE).id.tolist() == [0, 1, 2]
    with pytest.raises(granum.InvalidArgument, match="30"):
        granum.packing(**THREE, id=[30, 10, 30])
    with pytest.raises(granum.InvalidArgument, match="id"):
        granum.packing(**THREE, id=[30, 10])


# ---- files


@pytest.mark.parametrize("kind", ["vtu", "vtp"])
def test_what_is_written_for_paraview_is_read_back(packing, tmp_path, kind):
    grains, contacts = tmp_path / "grains.vtu", tmp_path / "contacts.vtp"
    granum.write_vtk(packing, grains)
    granum.write_vtk(packing, contacts)
    again = granum.read(grains, contacts)
    np.testing.assert_array_equal(again.position, packing.position)
    np.testing.assert_array_equal(again.id, packing.id)
    np.testing.assert_array_equal(again.contacts.normal_force, packing.contacts.normal_force)
    path = tmp_path / f"again.{kind}"
    path.write_text("old")
    granum.write_vtk(packing, str(path))
    assert path.read_text() == {"vtu": grains, "vtp": contacts}[kind].read_text()


def test_own_numbers_of_grains_are_written_too(tmp_path):
    packing = granum.packing(**THREE, **PAIRS, id=[30, 10, 20])
    path = tmp_path / "grains.vtu"
    granum.write_vtk(packing, path, fields={"speed": [0.5, 1.5, 2.5], "turn": np.arange(9).reshape(3, 3), "radius": [1, 2, 3]})
    text = path.read_text()
    assert text.count('Name="radius"') == 1 and "0.5 1.5 2.5" in " ".join(text.split())
    assert 'Name="turn" NumberOfComponents="3"' in text
    for wrong in ([1.0, 2.0], np.ones((3, 1, 1)), 1.0):
        with pytest.raises(granum.InvalidArgument, match="speed"):
            granum.write_vtk(packing, path, fields={"speed": wrong})
    for wrong in ([1.0], {1: [1.0, 2.0, 3.0]}):
        with pytest.raises(TypeError, match="fields"):
            granum.write_vtk(packing, path, fields=wrong)
    with pytest.raises(granum.InvalidArgument, match="fields"):
        granum.write_vtk(packing, tmp_path / "c.vtp", fields={"speed": [1, 2, 3]})
    with pytest.raises(granum.InvalidArgument, match=".vtu"):
        granum.write_vtk(packing, tmp_path / "c.vtk")
    with pytest.raises(FileNotFoundError):
        granum.write_vtk(packing, tmp_path / "none" / "c.vtu")


def test_patterns_find_files_in_folders_with_brackets_and_at_home(dump, tmp_path, monkeypatch):
    folder = tmp_path / "run [1]"
    folder.mkdir()
    for file in dump:
        (folder / file.name).symlink_to(file)
    assert len(granum.read(folder / "lammps_loose_p50.*.gz")) == 10000
    monkeypatch.setenv("HOME", str(folder))
    assert len(granum.read("~/lammps_loose_p50.*.gz")) == 10000
    with pytest.raises(granum.FileError, match="none"):
        granum.read(folder / "none.*")


# ---- questions


def test_every_element_may_be_of_another_sand():
    names = np.array([["toyoura"], ["ottawa"]])
    answer = granum.packing_answer(**SAND, sand=names, void_ratio=[0.7, 0.75], pressure=1e5)
    assert answer.shape == (2, 2)
    for k, name in enumerate(("toyoura", "ottawa")):
        one = granum.packing_answer(**SAND, sand=name, void_ratio=[0.7, 0.75], pressure=1e5)
        np.testing.assert_array_equal(answer.shear_modulus.value[k], one.shear_modulus.value)
        np.testing.assert_array_equal(answer.shear_modulus.high[k], one.shear_modulus.high)
    listed = granum.packing_answer(**SAND, sand=["toyoura", "ottawa"], void_ratio=0.7, pressure=1e5)
    np.testing.assert_array_equal(listed.shear_modulus.value, answer.shear_modulus.value[:, 0])
    with pytest.raises(granum.InvalidArgument, match="toyoura"):
        granum.packing_answer(**SAND, sand=["toyoura", "toyora"], void_ratio=0.7, pressure=1e5)
    assert granum.packing_answer(**SAND, sand=[], void_ratio=0.7, pressure=1e5).shape == (0,)
    for wrong in (["toyoura", None], [1, 2], 3.0):
        with pytest.raises(TypeError, match="sand"):
            granum.packing_answer(**SAND, sand=wrong, void_ratio=0.7, pressure=1e5)
    with pytest.raises(granum.InvalidArgument):
        granum.packing_answer(**SAND, sand=["toyoura", "ottawa"], void_ratio=[0.7] * 3, pressure=1e5)


def test_a_question_may_have_every_number_at_once():
    sand = dict(uniformity=1.5, least_void_ratio=0.6, largest_void_ratio=1.0, relative_density=0.625, fines=0.01, d50=4e-4)
    state = dict(stress_v=1e5, stress_h=5e4, coordination_number=5.0, mechanical_coordination_number=5.2, rolling=0.0)
    more = dict(fabric_anisotropy=0.1, tangential_ratio=0.9, saturation=0.5, shear_strain=1e-4, void_ratio=0.75)
    answer = granum.packing_answer(**SAND, **sand, **state, **more)
    arrays = {key: [value] * 2 for key, value in {**sand, **state, **more}.items()}
    np.testing.assert_array_equal(
        granum.packing_answer(**SAND, **arrays).strained_shear_modulus.value, answer.strained_shear_modulus.value
    )


# ---- xarray


def test_a_result_is_a_data_set():
    xarray = pytest.importorskip("xarray")
    pressure = np.array([[5e4], [1e5]])
    state = dict(law=LAW, radius=5e-4, void_ratio=[0.6, 0.65, 0.7], coordination_number=5.7, pressure=pressure)
    estimate = granum.uniform_strain(**state)
    data = estimate.to_xarray(dims=("pressure", "density"))
    assert isinstance(data, xarray.Dataset)
    assert data.G_vh.dims == ("pressure", "density")
    np.testing.assert_array_equal(data.G_vh, estimate.G_vh)
    assert data.stiffness.dims == ("pressure", "density", "voigt", "voigt_2")
    assert float(data.stiffness.sel(voigt=23, voigt_2=23)[0, 0]) == estimate.C44[0, 0]
    answer = granum.packing_answer(law=LAW, radius=5e-4, void_ratio=[0.6, 0.7], pressure=1e5)
    columns = answer.to_columns()
    for name, variable in answer.to_xarray().variables.items():
        if name in columns:
            np.testing.assert_array_equal(variable, columns[name])
    assert answer.to_xarray().shear_modulus_low.dims == ("dim_0",)
    with pytest.raises(granum.InvalidArgument, match="dims"):
        estimate.to_xarray(dims=["pressure"])


def test_a_data_set_of_a_stand_in(monkeypatch):
    """What is passed on, where xarray is not installed."""
    import sys
    import types

    stand_in = types.SimpleNamespace(Dataset=lambda variables, coordinates: (variables, coordinates))
    monkeypatch.setitem(sys.modules, "xarray", stand_in)
    estimate = granum.uniform_strain(law=LAW, radius=5e-4, void_ratio=[0.6, 0.7], coordination_number=5.7, pressure=1e5)
    variables, coordinates = estimate.to_xarray()
    assert variables["C11"][0] == ["dim_0"] and variables["stiffness"][0] == ["dim_0", "voigt", "voigt_2"]
    assert set(coordinates) == {"voigt", "voigt_2"} and "errors" not in variables
    waves = granum.plane_waves(estimate.stiffness, bulk_density=1700, direction=[0, 0, 1])
    variables, _ = waves.to_xarray(dims=["state"])
    assert variables["polarisation"][0] == ["state", "axis", "axis_2"] and variables["speed"][1].shape == (2, 3)
    scalar, _ = granum.uniform_strain(law=LAW, radius=5e-4, void_ratio=0.6, coordination_number=5.7, pressure=1e5).to_xarray()
    assert scalar["C11"][0] == [] and scalar["stiffness"][0] == ["voigt", "voigt_2"]
