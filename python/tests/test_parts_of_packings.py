# SPDX-License-Identifier: GPL-3.0-or-later
"""Contacts from overlaps, windows, and contacts that resist rolling."""

import granum
import numpy as np
import pytest


def cubic(edge=5, overlap=1e-6, **contacts):
    """Equal spheres on a cubic lattice in a cell that is not periodic."""
    pitch = 1e-3 - overlap
    places = pitch * (np.indices((edge,) * 3).reshape(3, -1).T + 0.5)
    cell = [edge * pitch] * 3
    return granum.packing(position=places, radius=0.5e-3, cell=cell, periodic=[False] * 3, **contacts)


def as_csv(packing, folder):
    """Files of the packing: grains, and contacts with their normal forces."""
    grains, contacts = folder / "grains.csv", folder / "contacts.csv"
    lines = [f"{k},{x},{y},{z},0.0005\n" for k, (x, y, z) in enumerate(packing.position)]
    grains.write_text("id,x_m,y_m,z_m,radius_m\n" + "".join(lines))
    c = packing.contacts
    forces = c.normal_force[:, None] * c.branch / np.linalg.norm(c.branch, axis=1)[:, None]
    lines = [f"{i},{j},{x},{y},{z}\n" for i, j, (x, y, z) in zip(c.i, c.j, forces)]
    contacts.write_text("id1,id2,fx_N,fy_N,fz_N\n" + "".join(lines))
    return grains, contacts


def test_windows_are_those_of_the_program(sphere, tmp_path, run_program):
    packing = granum.overlap_contacts(cubic(12), law=sphere)
    whole = granum.measure(packing, network=False, window=None)
    inside = granum.measure(packing, network=False)
    part = granum.measure(packing, network=False, window=[(4e-3, 8e-3), None, (None, 6e-3)])
    assert whole.interior is None
    assert whole.counts.coordination_number < 6
    assert inside.interior.microstructure.coordination_number == 6
    assert inside.microstructure.coordination_number == 6
    assert part.interior.grains == 4 * 12 * 6
    with pytest.raises(granum.InvalidArgument, match="window"):
        granum.measure(packing, window="middle")
    files = as_csv(packing, tmp_path)
    said = run_program("analyse", *files, "--no-network", "--grain-shear-modulus", "30GPa")["frames"][0]
    read = granum.measure(granum.read(*files), network=False, grain_shear_modulus=30e9)
    assert read.interior.void_ratio == said["window"]["void_ratio"]


def test_profiles_are_those_of_the_program_and_add_up(source, run_program):
    files = [str(source / "examples" / "data" / f"lammps_loose_p50.{kind}.gz") for kind in ("atoms", "contacts")]
    packing = granum.read(*files)
    found = granum.profile(packing, axis="x", slices=7)
    said = run_program("analyse", *files, "--no-network", "--profile", "x:7")["frames"][0]
    whole = granum.measure(packing, network=False)
    assert [one["shear_modulus"] for one in said["profile"]] == found["shear_modulus"].tolist()
    for k, name in enumerate(("xx", "yy", "zz", "xy", "xz", "yz")):
        assert [one["stress"][k] for one in said["profile"]] == found["stress_" + name].tolist()
    assert found["stress_yy"].mean() == pytest.approx(whole.stress.tensor[1, 1], rel=1e-12)
    assert found["solid_fraction"].mean() == pytest.approx(1 / (1 + whole.void_ratio), rel=1e-10)
    # A plane across which forces balance carries one stress: that of LAMMPS, quenched to 1e-4 of the mean force.
    assert np.ptp(found["stress_xx"]) < 1e-3 * found["stress_xx"].mean() < np.ptp(found["stress_yy"])
    assert np.isnan(granum.profile(granum.packing(position=[[0, 0, 0]], radius=1, cell=[4, 4, 4]))["shear_modulus"]).all()
    for wrong in (dict(axis="w"), dict(slices=0)):
        with pytest.raises(granum.InvalidArgument):
            granum.profile(packing, **wrong)


def test_one_rigid_body_among_single_grains_is_kept():
    places = [[0, 0, 0], [0.9e-3, 0, 0], [2e-3, 0, 0]]
    body = granum.packing(position=places, radius=0.5e-3, body=[0, 0, -1]).body
    assert body.tolist() == [0, 0, 1]
    assert len(granum.packing(position=places, radius=0.5e-3, body=[0, 0, 0]).body) == 0  # one of all is none
