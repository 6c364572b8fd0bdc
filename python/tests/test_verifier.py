# SPDX-License-Identifier: GPL-3.0-or-later
"""Specimens, compression, probes, shear, and the study that runs them all."""

import math
import subprocess
import sys
import textwrap
import types

import granum
import numpy as np
import pytest

LAW = granum.sphere(shear_modulus=30e9, poisson_ratio=0.15, radius=0.5e-3)
RECIPE = {
    "law": LAW,
    "radius": 0.5e-3,
    "friction_coefficient": math.tan(math.radians(26.5)),
    "kind": "dense",
    "grains": 80,
}


@pytest.fixture(scope="module")
def states():
    return list(granum.compress(granum.specimen(**RECIPE), [20e3, 50e3]))


def test_a_specimen_reaches_the_pressures_in_turn(states):
    assert [state.pressure for state in states] == [20e3, 50e3]
    for state in states:
        np.testing.assert_allclose(np.diag(state.stress), state.pressure, rtol=1e-3)
        assert state.unbalanced_force_ratio < 1e-5
    assert states[1].specimen.void_ratio < states[0].specimen.void_ratio


def test_a_path_goes_on_from_any_state_with_the_same_bits(states):
    (again,) = granum.compress(states[0].specimen, [50e3])
    assert again.specimen == states[1].specimen and again.specimen != states[0].specimen
    assert granum.specimen(**RECIPE) == granum.specimen(**RECIPE)
    assert granum.specimen(**{**RECIPE, "seed": 2}) != granum.specimen(**RECIPE)


SCENE = {
    "study": {
        "contacts": ["sphere"],
        "densities": ["dense"],
        "grains": 60,
        "pressures": [20e3, 40e3, 80e3],
        "probe_pressures": [40e3],
    },
    "grain.radius": "0.4mm",
}


def test_a_study_is_that_of_the_program(run_program, tmp_path):
    seen = []
    study = granum.verify(SCENE, progress=lambda done, what: seen.append(done))
    assert study.failures == [] and str(study)
    settings = "study.contacts=sphere study.densities=dense study.grains=60 study.pressures=20kPa,40kPa,80kPa"
    settings += " study.probe_pressures=40kPa grain.radius=0.4mm"
    said = run_program("verify", *[word for pair in settings.split() for word in ("--set", pair)])
    exponents = said["exponents"][0]
    assert study.exponents["network"][0] == exponents["network"]["value"]
    assert study.exponents["probe"].shape == (1,)
    states = said["specimens"][0]["states"]
    assert study.states["seed"] == [1, 1, 1]
    assert study.states["p_Pa"].tolist() == [20e3, 40e3, 80e3]
    assert study.states["G_network_Pa"].tolist() == [state["G_network_Pa"] for state in states]
    assert np.isfinite(study.states["G_hh_probe_Pa"]).tolist() == [False, True, False]
    assert [v.claim for v in study.verdicts] == [v["claim"] for v in said["verdicts"]]
    assert [v.decided for v in study.verdicts] == [v["decided"] for v in said["verdicts"]]
    assert seen == sorted(seen) and all(0 <= done <= 1 for done in seen)


def test_a_scene_file_is_the_same_scene(tmp_path):
    path = tmp_path / "scene.toml"
    path.write_text(
        '[study]\ncontacts = ["sphere"]\ndensities = ["dense"]\ngrains = 60\npressures = ["20kPa", "40kPa", "80kPa"]\n'
        'probe_pressures = ["40kPa"]\n[grain]\nradius = "0.4mm"\n'
    )
    assert granum.verify(path).states["e"].tolist() == granum.verify(SCENE).states["e"].tolist()
    path.write_text("[grain]\nradius = 0.4\n")
    with pytest.raises(granum.InvalidArgument, match="grain.radius"):
        granum.verify(path)


def test_an_exception_of_the_progress_ends_the_study():
    def refuse(done, what):
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough") as raised:
        granum.verify({**SCENE, "study": {**SCENE["study"], "grains": 1000}}, progress=refuse)
    assert raised.value.study.failures


def test_a_bar_of_tqdm_is_filled(monkeypatch):
    """With a stand-in for tqdm, which is optional."""
    bars = []

    class Bar:
        def __init__(self, total, unit, leave):
            self.n, self.total, self.closed = 0, total, False
            bars.append(self)

        def set_description(self, text):
            self.text = text

        def update(self, more):
            self.n += more

        def close(self):
            self.closed = True

    stand_in = types.ModuleType("tqdm.auto")
    stand_in.tqdm = Bar
    monkeypatch.setitem(sys.modules, "tqdm", types.ModuleType("tqdm"))
    monkeypatch.setitem(sys.modules, "tqdm.auto", stand_in)
    granum.verify({**SCENE, "study": {**SCENE["study"], "grains": 200}}, progress="tqdm")
    (bar,) = bars
    assert 0 < bar.n <= bar.total and bar.closed and bar.text


# Threads take no turns in these programs: the one that presses Ctrl-C runs as soon as the work gives the interpreter
# free, which is in the midst of it. Each work would take hours.
CTRL_C = """
import os, signal, sys, threading
import granum
go = threading.Event()


def press():
    go.wait()
    os.kill(os.getpid(), signal.SIGINT)
thread = threading.Thread(target=press)
thread.start()
sys.setswitchinterval(1000)
law = granum.sphere(shear_modulus=30e9, poisson_ratio=0.15, radius=0.5e-3)
go.set()
try:
    WORK
except KeyboardInterrupt as stop:
    print("stopped", *[len(study.failures) for study in [getattr(stop, "study", None)] if study])
"""
WORK = {
    "stopped": 'granum.specimen(law=law, radius=0.5e-3, friction_coefficient=0.5, kind="dense", grains=300_000)',
    "stopped 100": 'granum.verify({"study.grains": 20_000, "study.contacts": ["sphere"], "study.seeds": 50})',
}


@pytest.mark.parametrize("said", WORK)
def test_ctrl_c_ends_work_and_keeps_the_finished_part(said):
    program = CTRL_C.replace("WORK", WORK[said])
    done = subprocess.run([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True)
    assert done.returncode == 0 and done.stdout.strip() == said


def test_ctrl_c_keeps_the_states_of_a_path():
    program = """
    import os, signal
    import granum

    law = granum.sphere(shear_modulus=30e9, poisson_ratio=0.15, radius=0.5e-3)
    start = granum.specimen(law=law, radius=0.5e-3, friction_coefficient=0.5, kind="dense", grains=80)
    kept = []
    try:
        for state in granum.compress(start, [20e3 * (k + 1) for k in range(100000)]):
            kept.append(state)
            if len(kept) == 3:
                os.kill(os.getpid(), signal.SIGINT)
    except KeyboardInterrupt:
        print(len(kept))
    """
    done = subprocess.run([sys.executable, "-c", textwrap.dedent(program)], stdout=subprocess.PIPE, text=True)
    assert done.returncode == 0 and done.stdout.strip() == "3"


@pytest.mark.parametrize(
    "call, named",
    [
        (lambda: granum.specimen(**{**RECIPE, "kind": "medium"}), "medium"),
        (lambda: granum.specimen(**{**RECIPE, "grains": 3}), "grains"),
        (lambda: granum.specimen(**{**RECIPE, "friction_coefficient": -1}), "friction"),
        (lambda: granum.verify({"grain.colour": "red"}), "grain.colour"),
        (lambda: granum.verify({"study": {"grains": 3}}), "study.grains"),
        (lambda: granum.verify({"shear.largest_strain": 0.1}), "shear.largest_strain"),
        (lambda: granum.verify({"contact.cone_slope": 0.5, "study.contacts": ["sphere"]}), "contact.cone_slope"),
    ],
)


def test_what_no_specimen_and_no_scene_can_have_is_refused_by_name(call, named):
    with pytest.raises(granum.InvalidArgument, match=named):
        call()
