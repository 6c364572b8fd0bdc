# SPDX-License-Identifier: GPL-3.0-or-later
"""A contact network of 300 grains: matrix, motions, 6 x 6, modes, and what the program writes of them."""

import os
import subprocess

import granum
import numpy as np
import pytest

DENSITY = 2650.0


@pytest.fixture(scope="module")
def network():
    """A disordered network of 300 unequal grains, with stiffnesses of its own and forces out of balance."""
    random = np.random.default_rng(1)
    edge = 1e-3
    lattice = np.array([[x, y, z] for x in range(6) for y in range(10) for z in range(10) if (x + y + z) % 2 == 0])
    cell = edge * np.array([6.0, 10.0, 10.0]) / np.sqrt(2)
    position = edge * lattice / np.sqrt(2) + random.uniform(-1e-4, 1e-4, (len(lattice), 3))
    radius = random.uniform(0.35e-3, 0.6e-3, len(position))
    i, j = np.triu_indices(len(position), 1)
    branch = position[j] - position[i]
    branch -= cell * np.round(branch / cell)
    near = np.linalg.norm(branch, axis=1) < 1.2 * (radius[i] + radius[j])
    near &= random.random(len(i)) < 0.85
    i, j, branch = i[near], j[near], branch[near]
    k_n = random.uniform(1e5, 4e5, len(i))
    return granum.packing(
        position=position,
        radius=radius,
        cell=cell,
        contacts=np.stack([i, j], axis=1),
        branch=branch,
        forces=random.uniform(-0.1, 1, (len(i), 1)) * branch / edge + random.uniform(-0.1, 0.1, (len(i), 3)),
        normal_stiffness=k_n,
        tangential_stiffness=random.uniform(0.2, 1, len(i)) * k_n,
    )


def test_motions_take_the_energy_that_uniform_strain_has_too_much(network):
    pytest.importorskip("scipy")
    found = granum.measure(network, motions=True).network
    assert found.motions.shape == (6, len(network), 6)
    u = found.motions.reshape(6, -1)
    energy = u @ (granum.stiffness_matrix(network) @ u.T) / network.volume
    np.testing.assert_allclose(energy, found.affine - found.relaxed, rtol=0, atol=1e-8 * found.affine.max())
    assert granum.measure(network).network.motions is None


def test_modes_are_eigenvectors_of_the_matrix_with_the_masses(network):
    pytest.importorskip("scipy")
    modes, h = granum.lowest_modes(network, 12, DENSITY), granum.stiffness_matrix(network)
    assert modes.motions.shape == (12, len(network), 6) and (np.diff(modes.frequency) >= 0).all()
    mass = DENSITY * 4 / 3 * np.pi * network.radius**3
    masses = np.repeat(np.stack([mass, 0.4 * mass], axis=1), 3, axis=1).ravel()
    for frequency, motion in zip(modes.frequency, modes.motions.reshape(12, -1)):
        force = (2 * np.pi * frequency) ** 2 * masses * motion
        np.testing.assert_allclose(h @ motion, force, rtol=0, atol=1e-6 * np.abs(force).max())
    for name, call in (("grain_density", (3, -1.0)), ("count", (0, DENSITY))):
        with pytest.raises(granum.InvalidArgument, match=name):
            granum.lowest_modes(network, *call)


def test_without_stiffness_there_is_no_matrix(network):
    pytest.importorskip("scipy")
    grains = granum.packing(position=network.position, radius=network.radius, cell=network.cell)
    with pytest.raises(granum.InvalidArgument, match="material"):
        granum.stiffness_matrix(grains)
    law = granum.sphere(shear_modulus=30e9, poisson_ratio=0.15, radius=0.5e-3)
    assert granum.stiffness_matrix(grains, law=law).nnz > 0


def written(packing, folder):
    """Tables that the program reads."""
    grains, contacts, c = folder / "grains.csv", folder / "contacts.csv", packing.contacts
    table = np.column_stack([np.arange(len(packing)), packing.position, packing.radius])
    np.savetxt(grains, table, delimiter=",", header="id,x_m,y_m,z_m,radius_m", comments="", fmt="%.17g")
    force = c.normal_force[:, None] * c.normal + c.tangential_force
    table = np.column_stack([c.i, c.j, c.branch, force, c.normal_stiffness, c.tangential_stiffness])
    names = "id1,id2,lx_m,ly_m,lz_m,fx_N,fy_N,fz_N,kn,kt"
    np.savetxt(contacts, table, delimiter=",", header=names, comments="", fmt="%.17g")
    return [str(grains), str(contacts), "--box", ",".join(f"{float(edge)!r}m" for edge in np.diag(packing.cell))]


def test_the_program_writes_the_same(network, tmp_path, run_program):
    pytest.importorskip("scipy")
    from scipy.io import mmread

    given = [*written(network, tmp_path), "--grain-density", f"{DENSITY}kg/m3"]
    out = tmp_path / "out"
    asked = ["--modes", 4, "--hessian", tmp_path / "h.mtx", "--out", out, "--paraview", "--xyz"]
    run_program("analyse", *given, *asked)
    same = granum.read(*given[:2], box=np.diag(network.cell))
    matrix = granum.stiffness_matrix(same)
    np.testing.assert_allclose(mmread(tmp_path / "h.mtx").toarray(), matrix.toarray(), rtol=1e-15)
    modes = granum.lowest_modes(same, 4, DENSITY)
    lines = [line for line in (out / "modes.csv").read_text().splitlines() if not line.startswith("#")]
    assert lines[0] == "frame,frequency_Hz,participation_ratio"
    table = np.array([line.split(",") for line in lines[1:]], dtype=float)
    np.testing.assert_allclose(table[:, 1], modes.frequency, rtol=1e-12)
    np.testing.assert_allclose(table[:, 2], modes.participation_ratio, rtol=1e-12)

    # a grain's line: id, position, radius, contacts, rattler, pressure, nine of stress, six displacements
    lines = (out / "grains-0.xyz").read_text().splitlines()
    assert int(lines[0]) == len(network) and 'pbc="T T T"' in lines[1] and "grain_stress:R:9" in lines[1]
    values = np.array([line.split() for line in lines[2:]], dtype=float)
    assert values.shape == (len(network), 1 + 3 + 4 + 9 + 18)
    assert (values[:, 1:4] == same.position).all()
    volume = 4 / 3 * np.pi * network.radius**3
    stress = (volume[:, None] * values[:, 8:17]).sum(axis=0).reshape(3, 3) / network.volume
    expected = granum.measure(same, network=False).stress.tensor
    np.testing.assert_allclose(stress, expected, rtol=0, atol=1e-12 * np.abs(expected).max())
    motions = granum.measure(same, motions=True).network.motions
    np.testing.assert_allclose(values[:, 17:35].reshape(-1, 6, 3), motions[:, :, :3].swapaxes(0, 1), rtol=0, atol=0)
    assert "nonaffine_12" in (out / "grains-0.vtu").read_text()

    command = [os.environ["GRANUM_PROGRAM"], "analyse", *given[:4], "--hessian", str(tmp_path / "h.mtx")]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 3
    assert subprocess.run([*command, "--force"], capture_output=True).returncode in (0, 1)


def test_the_program_writes_d2min_since_the_frame_ahead(network, tmp_path, run_program):
    edges = np.diag(network.cell)
    states = [network.position + k * np.random.default_rng(k).normal(size=network.position.shape) * 1e-5 for k in range(3)]
    frame = "ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\nITEM: BOX BOUNDS pp pp pp\n{}ITEM: ATOMS id radius x y z\n{}"
    bounds = "".join(f"0 {edge!r}\n" for edge in edges.tolist())
    with open(tmp_path / "a.dump", "w") as dump:
        for step, state in enumerate(states):
            rows = (f"{k + 1} {r!r} {x!r} {y!r} {z!r}\n"
                    for k, (r, (x, y, z)) in enumerate(zip(network.radius.tolist(), state.tolist())))
            dump.write(frame.format(step, len(network), bounds, "".join(rows)))
    run_program("analyse", tmp_path / "a.dump", "--no-network", "--out", tmp_path / "out", "--xyz", "--paraview")
    read = list(granum.frames(tmp_path / "a.dump"))
    assert "D2min" not in (tmp_path / "out" / "grains-0.xyz").read_text()
    for step in (1, 2):
        lines = (tmp_path / "out" / f"grains-{step}.xyz").read_text().splitlines()
        assert "D2min:R:1" in lines[1]
        values = np.array([float(line.split()[-1]) for line in lines[2:]])
        np.testing.assert_allclose(values, granum.d2min(read[step - 1], read[step]), rtol=1e-12)
        assert '"D2min"' in (tmp_path / "out" / f"grains-{step}.vtu").read_text()
