# SPDX-License-Identifier: GPL-3.0-or-later
"""No call keeps memory: what 1,000 calls would leave behind is far more than what is allowed here."""

import gc
import os

import granum
import numpy as np
import pytest

LAW = granum.sphere(shear_modulus=30e9, poisson_ratio=0.15, radius=0.5e-3)
VOID_RATIOS = np.linspace(0.4, 0.8, 500)
SMALL = {
    "position": np.random.default_rng(1).random((500, 3)),
    "radius": 0.05,
    "cell": [1, 1, 1],
}


def estimate():
    granum.relaxed(
        law=LAW,
        radius=0.5e-3,
        void_ratio=VOID_RATIOS,
        coordination_number=5.7,
        pressure=1e5,
        rattler_fraction=0.02,
    ).stiffness.sum()


def refusal():
    result = granum.uniform_strain(
        law=LAW, radius=0.5e-3, void_ratio=-VOID_RATIOS, coordination_number=5.7, pressure=1e5
    )
    assert len(result.errors) == len(VOID_RATIOS)


def exception():
    with pytest.raises(granum.InvalidArgument):
        granum.uniform_strain(law=LAW, radius=0.5e-3, void_ratio=-1, coordination_number=5.7, pressure=1e5)
    with pytest.raises(TypeError):
        granum.uniform_strain(
            law=LAW, radius=VOID_RATIOS, void_ratio="x", coordination_number=5.7, pressure=1e5
        )


def arrays():
    packing = granum.packing(**SMALL)
    packing.position.sum()
    len(packing.contacts.branch)


def measurement():
    granum.measure(granum.packing(**SMALL), law=LAW, network=False).rungs


def resident():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


@pytest.mark.parametrize("call", [estimate, refusal, exception, arrays, measurement])
def test_memory_is_flat(call):
    for _ in range(200):
        call()
    gc.collect()
    before = resident()
    for _ in range(1000):
        call()
    gc.collect()
    least_leak = 4000 * 1000  # a row of 500 doubles, or a small packing, a call
    assert resident() - before < least_leak / 2
