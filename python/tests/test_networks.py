# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact networks of 300 grains by numpy, from their contacts: matrix, motions, 6 x 6, modes, stresses of grains."""

import os
import subprocess

import granum
import numpy as np
import pytest

PAIRS = ((0, 0), (1, 1), (2, 2), (1, 2), (0, 2), (0, 1))
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


@pytest.fixture(scope="module")
def dense(network):
    """H, W and A by their definition, of u and R w of all grains."""
    size = 6 * len(network)
    h, w, a = np.zeros((size, size)), np.zeros((size, 6)), np.zeros((6, 6))
    c = network.contacts
    for i, j, branch, k_n, k_t in zip(c.i, c.j, c.branch, c.normal_stiffness, c.tangential_stiffness):
        n = branch / np.linalg.norm(branch)
        turn = np.array([[0, -n[2], n[1]], [n[2], 0, -n[0]], [-n[1], n[0], 0]])  # turn @ w = n x w
        lever = np.linalg.norm(branch) / (network.radius[i] + network.radius[j])
        motion = np.zeros((3, 12))  # of the two surfaces against each other, by u_i, R_i w_i, u_j, R_j w_j
        motion[:, 0:3], motion[:, 6:9] = -np.eye(3), np.eye(3)
        motion[:, 3:6] = motion[:, 9:12] = lever * turn
        strain = np.zeros((3, 6))
        for case, (p, q) in enumerate(PAIRS):
            strain[p, case] += branch[q] / 2
            strain[q, case] += branch[p] / 2
        k = k_t * np.eye(3) + (k_n - k_t) * np.outer(n, n)
        rows = np.r_[6 * i : 6 * i + 6, 6 * j : 6 * j + 6]
        h[np.ix_(rows, rows)] += motion.T @ k @ motion
        w[rows] += motion.T @ k @ strain
        a += strain.T @ k @ strain
    return h, w, a


@pytest.fixture(scope="module")
def vibrations(network, dense):
    """Roots of the masses of all unknowns, eigenvalues and mass-weighted vectors, and the number of free motions."""
    mass = DENSITY * 4 / 3 * np.pi * network.radius**3
    root = np.sqrt(np.concatenate([np.tile(mass, (3, 1)), np.tile(0.4 * mass, (3, 1))]).T.ravel())
    values, vectors = np.linalg.eigh(dense[0] / np.outer(root, root))
    free = int((values < 1e-9 * values[-1]).sum())  # translations, and grains that turn about their two contacts
    assert 3 <= free < 10 and values[free] > 1e-6 * values[-1]
    return root, values, vectors, free


def test_matrix_motions_and_stiffness_are_those_of_numpy(network, dense, vibrations):
    pytest.importorskip("scipy")
    h, w, a = dense
    found = granum.stiffness_matrix(network)
    assert found.shape == h.shape and found.format == "csr"
    assert (found != found.T).nnz == 0
    measured = granum.measure(network, motions=True)
    assert not measured.counts.is_rattler.any(), "their contacts would be in h, w and a"
    np.testing.assert_allclose(found.toarray(), h, rtol=0, atol=1e-14 * np.abs(h).max())

    root, values, vectors, free = vibrations
    weighted = vectors[:, free:]
    moved = -(weighted / values[free:] @ (weighted.T @ (w / root[:, None]))) / root[:, None]
    stiffness = (a + w.T @ moved) / network.volume
    np.testing.assert_allclose(measured.network.relaxed, stiffness, rtol=0, atol=1e-9 * stiffness.max())
    motions = measured.network.motions
    assert motions.shape == (6, len(network), 6)
    for case in range(6):
        force = found @ motions[case].ravel() + w[:, case]
        assert np.abs(force).max() < 1e-8 * np.abs(w).max()
        np.testing.assert_allclose(motions[case, :, :3].mean(axis=0), 0, atol=1e-12 * np.abs(moved).max())
    assert granum.measure(network).network.motions is None


def test_modes_are_those_of_numpy(network, vibrations):
    root, values, vectors, free = vibrations
    modes = granum.lowest_modes(network, 12, DENSITY)
    np.testing.assert_allclose((2 * np.pi * modes.frequency) ** 2, values[free : free + 12], rtol=1e-9)
    assert modes.motions.shape == (12, len(network), 6)
    for k in range(12):
        energy = (vectors[:, free + k] ** 2).reshape(-1, 6).sum(axis=1)
        ratio = 1 / (len(network) * (energy**2).sum())
        assert modes.participation_ratio[k] == pytest.approx(ratio, rel=1e-6)
        weighted = root * modes.motions[k].ravel()
        assert abs(weighted @ vectors[:, free + k]) == pytest.approx(1, abs=1e-9)
    with pytest.raises(granum.InvalidArgument, match="grain_density"):
        granum.lowest_modes(network, 3, -1.0)
    with pytest.raises(granum.InvalidArgument, match="count"):
        granum.lowest_modes(network, 0, DENSITY)


def test_without_stiffness_there_is_no_matrix(network):
    pytest.importorskip("scipy")
    grains = granum.packing(position=network.position, radius=network.radius, cell=network.cell)
    with pytest.raises(granum.InvalidArgument, match="material"):
        granum.stiffness_matrix(grains)
    law = granum.sphere(shear_modulus=30e9, poisson_ratio=0.15, radius=0.5e-3)
    assert granum.stiffness_matrix(grains, law=law).nnz > 0


def test_d2min_is_the_residual_of_a_fit_by_numpy(network):
    reach, cell = 1.5, network.cell
    moved = network.position + np.random.default_rng(3).normal(size=network.position.shape) * 2e-5
    moved[::7] += cell[:, 0]  # through a face
    before = granum.packing(position=network.position, radius=network.radius, cell=cell)
    after = granum.packing(position=moved, radius=network.radius, cell=cell)
    found = granum.d2min(before, after, reach=reach)

    def branches(position, grain):
        branch = position - position[grain]
        return branch - (cell @ np.round(np.linalg.solve(cell, branch.T))).T

    for grain in range(len(network)):
        old = branches(network.position, grain)
        size = np.linalg.norm(old, axis=1)
        near = (size < reach * (network.radius + network.radius[grain])) & (size > 0)
        new = branches(moved, grain)[near]
        matrix = np.linalg.lstsq(old[near], new, rcond=None)[0]
        assert found[grain] == pytest.approx(((new - old[near] @ matrix) ** 2).sum(), rel=1e-9)


@pytest.mark.parametrize("overlap", [-2e-7, 1e-6])
def test_stiffness_of_a_jkr_contact_by_roots_of_numpy(overlap):
    pytest.importorskip("scipy")
    radius, modulus, nu, gamma = 0.5e-3, 5e6, 0.3, 0.1
    stiff, reduced = modulus / (1 - nu), radius / 2

    def state(d):
        """Contact radius and force: u^4 - 2 s R u - R d = 0 of u = a^(1/2)."""
        s = np.sqrt(np.pi * gamma / stiff)
        roots = np.roots([1, 0, 0, -2 * s * reduced, -reduced * d])
        a = max(root.real for root in roots if abs(root.imag) < 1e-9 * abs(root)) ** 2
        return a, 4 * stiff * a**3 / (3 * reduced) - 4 * np.sqrt(np.pi * gamma * stiff * a**3)

    step = 1e-4 * abs(overlap)
    slope = (state(overlap + step)[1] - state(overlap - step)[1]) / (2 * step)
    edge = 2 * radius - overlap  # a row of three grains, closed through the face
    row = granum.packing(
        position=[[0, 0, 0], [edge, 0, 0], [2 * edge, 0, 0]], radius=radius, cell=[3 * edge, 5e-3, 5e-3],
        contacts=[[0, 1], [1, 2], [2, 0]], forces=[[state(overlap)[1], 0, 0]] * 3,
    )
    material = dict(grain_shear_modulus=modulus, grain_poisson_ratio=nu, tangential_ratio=0.5)
    for source in ("overlap", "force"):
        matrix = granum.stiffness_matrix(row, adhesion=("jkr", gamma), stiffness_from=source, **material).toarray()
        assert matrix[0, 0] == pytest.approx(2 * slope, rel=1e-6)
        assert matrix[1, 1] == pytest.approx(2 * 0.5 * 2 * stiff * state(overlap)[0], rel=1e-9)
    with pytest.raises(granum.InvalidArgument, match="adhesion"):
        granum.measure(row, adhesion=("jkr", -1.0), **material)
    with pytest.raises(granum.InvalidArgument, match="material"):
        granum.measure(row, adhesion=("jkr", gamma))


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
    assert done.returncode == 3 and "exists already" in done.stderr
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
