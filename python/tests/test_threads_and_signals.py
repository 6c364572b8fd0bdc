# SPDX-License-Identifier: GPL-3.0-or-later
"""Long calls and iterators beside other threads, and under Ctrl-C."""

import os
import signal
import subprocess
import sys
import threading
import time

import granum
import pytest

TOGETHER = 4  # threads


def consume_together(iterator):
    """What several threads get from one iterator: its items, and what it raised."""
    begin, items, raised = threading.Barrier(TOGETHER), [], []

    def consume():
        begin.wait()
        while True:
            try:
                items.append(next(iterator))
            except StopIteration:
                return
            except ValueError as error:
                raised.append(type(error))
                time.sleep(1e-3)

    threads = [threading.Thread(target=consume) for _ in range(TOGETHER)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    return items, raised


def start(sphere, grains):
    return granum.specimen(law=sphere, radius=5e-4, friction_coefficient=0.5, kind="dense", grains=grains)


def test_a_path_advances_in_one_thread_at_a_time(sphere):
    specimen = start(sphere, 60)
    pressures = [20e3, 30e3, 40e3, 50e3]
    items, raised = consume_together(granum.compress(specimen, pressures))
    items.sort(key=lambda state: state.pressure)
    assert [state.pressure for state in items] == pressures
    alone = list(granum.compress(specimen, pressures))
    assert [state.specimen for state in items] == [state.specimen for state in alone]
    assert set(raised) <= {ValueError}  # whether two meet is a matter of their speed


def test_a_test_advances_in_one_thread_at_a_time(sphere):
    at_rest = next(granum.compress(start(sphere, 60), [20e3])).specimen
    shear = dict(path="TXC", mean_stress=20e3, strain_step=1e-3, largest_strain=4e-3, inertial_number=0.01)
    items, raised = consume_together(granum.shear(at_rest, **shear))
    items.sort(key=lambda point: point.step)
    alone = list(granum.shear(at_rest, **shear))
    assert [(point.step, point.specimen) for point in items] == [(point.step, point.specimen) for point in alone]
    assert set(raised) <= {ValueError}


def test_frames_are_read_by_one_thread_at_a_time(dump, packing):
    frames = granum.frames(*dump)
    items, raised = consume_together(frames)
    assert items == [packing] and frames.skipped == 0
    assert set(raised) <= {ValueError}


COMMON = """
import granum, numpy as np, os, signal, sys
signal.signal(signal.SIGINT, signal.default_int_handler)  # which jobs in the background ignore
law = granum.sphere(shear_modulus=30e9, poisson_ratio=0.15, radius=0.5e-3)


def long_array(rows, low=50e3, high=500e3): return np.linspace(low, high, rows)
"""
LONG_CALLS = {  # a minute and more, or without an end
    "answers": """granum.packing_answer(law=law, radius=1e-4, void_ratio=0.7, pressure=long_array(400_000),
        sand="toyoura", saturation=1.0, grain_density=2650.0)""",
    "predictions": """granum.infer(law=law, radius=1e-4, void_ratio=0.7, pressure=1e5, G=1e8, relative_error=0.05,
        sand="toyoura").predict("G", pressure=long_array(400_000))""",
    "inference": """granum.infer(law=law, radius=5e-4, void_ratio=0.58, pressure=long_array(40_000),
        G=3e8 * (long_array(40_000) / 1e5)**0.4, relative_error=0.05)""",
    "inference of a sand": """granum.infer(law=law, radius=1e-4, void_ratio=0.7, pressure=long_array(40_000),
        G=1e8 * (long_array(40_000) / 1e5)**0.5, relative_error=0.05, sand="toyoura")""",
    "specimen": """granum.specimen(law=law, radius=5e-4, friction_coefficient=0.5, kind="loose", grains=100_000)""",
    "endless file": "granum.read(sys.argv[1])",
}


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="needs a pipe with a name")
@pytest.mark.parametrize("call", LONG_CALLS.values(), ids=LONG_CALLS)
def test_ctrl_c_ends_a_long_call(call, tmp_path):
    pipe = tmp_path / "grains.csv"
    os.mkfifo(pipe)
    before = os.times().children_user
    script = COMMON + f"print('begun', flush=True)\ntry: {call}\nexcept KeyboardInterrupt: print('heard')\n"
    child = subprocess.Popen(
        [sys.executable, "-c", script, str(pipe)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )
    writer = None
    try:
        assert child.stdout.readline() == "begun\n"
        if "argv" in call:  # a header, and never a grain
            writer = pipe.open("w")
            print("id,x,y,z,radius", file=writer, flush=True)
        time.sleep(1)
        assert child.poll() is None
        child.send_signal(signal.SIGINT)
        out, err = child.communicate(timeout=50)
        assert (out, err) == ("heard\n", "")
        assert os.times().children_user - before < 12  # of the processor, that others may use too
    finally:
        child.kill()
        if writer:
            writer.close()
