# SPDX-License-Identifier: GPL-3.0-or-later
"""Packings out of files and of arrays, their views, and what is measured on them."""

import copy
import errno
import os
import pickle
import subprocess
import sys
import threading

import granum
import numpy as np
import pytest


def arrays_of(packing):
    """The packing as another code holds it: in an order of its own, pairs in both senses."""
    contacts = packing.contacts
    order = np.random.default_rng(1).permutation(len(contacts))
    turned = np.random.default_rng(2).random(len(contacts)) < 0.5
    pairs = np.stack([contacts.i, contacts.j], axis=1).astype(np.int64)
    branch = contacts.branch
    normal = branch / np.linalg.norm(branch, axis=1)[:, None]
    np.testing.assert_allclose(contacts.normal, normal, rtol=0, atol=1e-15)
    sense = np.where(turned, -1.0, 1.0)[:, None]
    pairs = np.where(turned[:, None], pairs[:, ::-1], pairs)
    return {
        "position": packing.position,
        "radius": packing.radius,
        "cell": packing.cell,
        "contacts": pairs[order],
        "branch": (sense * branch)[order],
        "overlap": contacts.overlap[order],
        "normal_force": contacts.normal_force[order],
        "tangential_force": (sense * contacts.tangential_force)[order],
    }, (sense * (contacts.normal_force[:, None] * normal + contacts.tangential_force))[order]


def test_a_packing_of_arrays_is_that_of_files(packing, sphere):
    arrays, forces = arrays_of(packing)
    same = granum.packing(**arrays)
    assert same == packing
    assert same.contacts.j.tolist() == packing.contacts.j.tolist()
    found, expected = granum.measure(same, law=sphere), granum.measure(packing, law=sphere)
    assert found.network.relaxed.tolist() == expected.network.relaxed.tolist()
    assert found.stress.tensor.tolist() == expected.stress.tensor.tolist()

    # the whole force, and lines of centres from the nearest images
    for name in ("branch", "overlap", "normal_force", "tangential_force"):
        del arrays[name]
    near = granum.packing(**arrays, forces=forces)
    np.testing.assert_allclose(near.contacts.branch, packing.contacts.branch, atol=1e-12 * 1e-3, rtol=1e-9)
    np.testing.assert_allclose(
        near.contacts.normal_force, packing.contacts.normal_force, rtol=1e-7, atol=1e-9
    )
    np.testing.assert_allclose(
        granum.measure(near, law=sphere, network=False).stress.tensor,
        expected.stress.tensor,
        rtol=1e-6,
        atol=1e-3,
    )


def test_views_show_the_memory_of_the_packing_and_keep_it(dump):
    packing = granum.read(*dump)
    position, branch = packing.position, packing.contacts.branch
    assert position.shape == (10000, 3) and branch.shape == (20172, 3)
    assert not position.flags.owndata and not branch.flags.owndata
    assert np.shares_memory(position, packing.position) and np.shares_memory(branch, packing.contacts.branch)
    with pytest.raises(ValueError):
        position[0, 0] = 0
    first = position[0].copy(), branch[0].copy()
    del packing
    assert (position[0] == first[0]).all() and (branch[0] == first[1]).all()


def test_patterns_and_paths(source, packing):
    pattern = source / "examples" / "data" / "lammps_loose_p50.*.gz"
    assert granum.read(str(pattern)) == packing
    assert [frame == packing for frame in granum.frames(pattern)] == [True]
    assert len(granum.formats()) == 8


def test_a_file_error_has_path_and_line(tmp_path):
    missing = tmp_path / "nothing.csv"
    with pytest.raises(granum.FileError) as refused:
        granum.read(missing)
    assert isinstance(refused.value, OSError) and refused.value.path == str(missing)
    table = tmp_path / "grains.csv"
    table.write_text("x_m,y_m,z_m,radius_m\n0,0,0,1\n2,0,zero,1\n")
    with pytest.raises(granum.FileError) as refused:
        granum.read(table)
    assert (refused.value.path, refused.value.line) == (str(table), 3)


def test_bytes_of_names_and_files_need_not_be_utf8(tmp_path):
    table = os.path.join(os.fsencode(tmp_path), b"\xff.csv")
    try:
        open(table, "wb").close()
    except OSError:
        pytest.skip("this file system has names of UTF-8 only")
    for text in (b"", b"id,x_mm\n1,bad\n", b"x_m,y_m,z_m,radius_m,\xe4\n0,0,\xe4,1,1\n", b"\xe4\n", b"<VTKFile \xe4=\x80>"):
        with open(table, "wb") as file:
            file.write(text)
        for name in (table, os.fsdecode(table)):
            with pytest.raises(granum.FileError) as refused:
                granum.read(name)
            assert refused.value.path == os.fsdecode(table)
            assert "\\xff.csv" in str(refused.value) and str(refused.value).encode()


def test_a_file_that_is_not_there_is_what_open_says_it_is(tmp_path):
    missing, folder = tmp_path / "none.atoms", tmp_path / "a folder"
    folder.mkdir()
    for path, kind, number in ((missing, FileNotFoundError, errno.ENOENT), (folder, OSError, errno.EISDIR)):
        with pytest.raises(granum.FileError) as refused:
            granum.read(str(path))
        assert isinstance(refused.value, kind) and isinstance(pickle.loads(pickle.dumps(refused.value)), kind)
        assert (refused.value.errno, refused.value.filename) == (number, str(path))
        assert str(path) in str(refused.value)


def test_a_scene_in_a_file_needs_a_reader_of_toml(monkeypatch, tmp_path):
    for name in ("tomllib", "tomli"):
        monkeypatch.setitem(sys.modules, name, None)
    with pytest.raises(granum.InvalidArgument, match="tomli"):
        granum.verify(tmp_path / "scene.toml")


def test_a_scene_that_is_no_toml_is_refused(tmp_path):
    pytest.importorskip("tomllib")
    scene = tmp_path / "scene.toml"
    for text in (b"grains =", b"# \xe4\n"):
        scene.write_bytes(text)
        with pytest.raises(granum.FileError) as refused:
            granum.verify(scene)
        assert refused.value.path == str(scene)


def test_several_states_are_not_read_as_one(tmp_path, source):
    import gzip

    atoms = gzip.open(source / "examples" / "data" / "lammps_loose_p50.atoms.gz", "rt").read()
    twice = tmp_path / "twice.dump"
    twice.write_text(atoms + atoms.replace("102830", "102831"))
    assert len(list(granum.frames(twice))) == 2
    with pytest.raises(granum.InvalidArgument):
        granum.read(twice)


def frame_of(step, x):
    """A frame of a dump of two grains, the first at x."""
    return (
        f"ITEM: TIMESTEP\n{step}\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp pp\n0 9\n0 9\n0 9\n"
        f"ITEM: ATOMS id radius x y z\n1 0.5 {x} 0 0\n2 0.5 {x} 0.9 0\n"
    )


def test_a_restarted_job_is_answered_by_the_later_run(tmp_path):
    dump = tmp_path / "run.dump"
    dump.write_text("".join(frame_of(*at) for at in [(0, 1), (10, 1), (20, 1), (10, 2), (30, 2)]))
    with pytest.warns(UserWarning, match="10"):
        seen = [(frame.step, frame.position[0, 0]) for frame in granum.frames(dump)]
    assert seen == [(0, 1), (10, 2), (30, 2)]


def test_numbers_without_units_are_si_where_the_user_says_so(tmp_path):
    table = tmp_path / "grains.csv"
    table.write_text("x,y,z,radius\n0,0,0,1\n2,0,0,1\n")
    with pytest.raises(granum.FileError):
        granum.read(table)
    packing = granum.read(table, units="si")
    assert packing.radius.tolist() == [1, 1]
    with pytest.raises(granum.InvalidArgument, match="units"):
        granum.read(table, units="mm")


TRIPLE = {
    "position": [[0, 0, 0], [0.9, 0, 0], [0.45, 0.8, 0]],
    "radius": 0.5,
    "cell": [4, 4, 4],
    "contacts": [[0, 1], [1, 2]],
    "normal_force": [1.0, 2.0],
}


@pytest.mark.parametrize("name", ["position", "radius", "cell", "contacts", "normal_force", "branch"])
def test_arrays_of_other_types_are_refused_by_name(name):
    for wrong in ("text", [["a", "b"]], {"a": 1}):
        with pytest.raises(TypeError, match=name):
            granum.packing(**{**TRIPLE, name: wrong})


def test_numbers_of_grains_are_integers():
    with pytest.raises(TypeError, match="contacts"):
        granum.packing(**{**TRIPLE, "contacts": [[0.0, 1.0], [1.0, 2.0]]})
    small = granum.packing(**{**TRIPLE, "contacts": np.array([[0, 1], [1, 2]], dtype=np.uint16)})
    assert small.contacts.j.tolist() == [1, 2]


def test_spheres_without_contacts_touch_where_they_overlap(packing, sphere):
    grains = granum.packing(position=packing.position, radius=packing.radius, cell=packing.cell)
    assert len(grains.contacts) == 0
    found = granum.measure(grains, law=sphere)
    pressing = (packing.contacts.overlap > 0).sum()
    assert found.counts.contacts == pressing
    assert found.network.converged


def test_copies_and_pickles_are_the_same_packing(packing):
    for other in (copy.copy(packing), copy.deepcopy(packing), pickle.loads(pickle.dumps(packing))):
        assert other == packing
        assert (
            other.notes == packing.notes and other.step == packing.step and other.periodic == packing.periodic
        )
        assert (other.id == packing.id).all()
    assert granum.packing(**TRIPLE) != packing


def test_two_threads_measure_at_once(packing, sphere):
    expected = granum.measure(packing, law=sphere).network.relaxed
    found = [None, None]

    def measure(k):
        found[k] = granum.measure(packing, law=sphere).network.relaxed

    threads = [threading.Thread(target=measure, args=(k,)) for k in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all((matrix == expected).all() for matrix in found)


def ran_meanwhile(call):
    """Whether this thread ran while another one was in the call, between two lines of Python."""
    began, ended = threading.Event(), threading.Event()

    def work():
        began.set()
        call()
        ended.set()

    thread = threading.Thread(target=work)
    thread.start()
    began.wait()
    meanwhile = not ended.is_set()
    thread.join()
    return meanwhile


def test_python_runs_while_a_packing_is_measured(packing, sphere):
    """Threads take no turns here, so that another one runs only if measuring gives the interpreter free."""
    interval = sys.getswitchinterval()
    sys.setswitchinterval(1000)
    try:
        assert any(ran_meanwhile(lambda: granum.measure(packing, law=sphere)) for _ in range(20))
        assert not ran_meanwhile(lambda: sum(range(1000)))
    finally:
        sys.setswitchinterval(interval)


def test_the_package_says_what_it_is_and_runs_the_program(tmp_path):
    def run(path, *arguments):
        environment = {**os.environ, "PATH": path}
        return subprocess.run([sys.executable, "-m", "granum", *arguments], env=environment, capture_output=True, text=True)

    assert granum.__version__ in run("/nowhere").stdout
    assert run("/nowhere", "estimate").returncode == 2
    program = tmp_path / "granum"
    program.write_text('#!/bin/sh\necho "$@"\n')
    program.chmod(0o755)
    assert run(str(tmp_path), "estimate", "--json").stdout == "estimate --json\n"


@pytest.mark.parametrize(
    "name, wrong",
    [
        ("position", [[0, 0], [1, 0], [0, 1]]),
        ("radius", [0.5, 0.5]),
        ("radius", [0.5, -0.5, 0.5]),
        ("cell", [4, 4]),
        ("contacts", [[0, 1, 2]]),
        ("contacts", [[0, 1], [1, 3]]),
        ("contacts", [[0, 1], [1, -1]]),
        ("normal_force", [1.0]),
        ("branch", [[0.9, 0, 0], [0, 0, 0]]),
        ("forces", [[1, 0, 0], [2, 0, 0]]),
        ("tangential_force", [[0, 0, 1]]),
    ],
)


def test_arrays_that_are_no_packing_are_refused(name, wrong):
    with pytest.raises(granum.InvalidArgument, match={"branch": "contacts", "forces": "force"}.get(name, name)):
        granum.packing(**{**TRIPLE, name: wrong})
