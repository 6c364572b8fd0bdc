# SPDX-License-Identifier: GPL-3.0-or-later
"""Exponents, uncertain inputs and the ladder, each against another way to the same number."""

import granum
import numpy as np
import pytest

LAW = granum.sphere(shear_modulus=30e9, poisson_ratio=0.15, radius=0.5e-3)
STATE = {
    "law": LAW,
    "radius": 0.5e-3,
    "void_ratio": 0.6,
    "coordination_number": 5.7,
    "fabric_anisotropy": 0.1,
    "stress_v": 100e3,
    "stress_h": 60e3,
    "mechanical_coordination_number": 5.9,
}
RUNGS = [0, 1, 2, 3, "uniform_stress"]


def slope(rung, name, member="G_vh", step=1e-4, **state):
    """d ln X/d ln input by central differences."""
    state = {**STATE, **state}
    values = np.array([state[name] * np.exp(-step), state[name] * np.exp(step)])
    return np.diff(np.log(getattr(granum.answer(rung=rung, **{**state, name: values}), member)))[0] / (
        2 * step
    )


@pytest.mark.parametrize("rung", RUNGS)
def test_exponents_are_slopes(rung):
    exponents = granum.exponents(rung=rung, modulus="G_vh", **STATE)
    assert exponents.stress_v == pytest.approx(slope(rung, "stress_v"), abs=1e-6)
    assert exponents.stress_h == pytest.approx(slope(rung, "stress_h"), abs=1e-6)
    # Overlaps w shorten the branches of rung 3, which takes (2-b)(1-b) w/(1-w) from b = 1/3.
    pressure = (STATE["stress_v"] + 2 * STATE["stress_h"]) / 3
    force = 4 * np.pi * STATE["radius"] ** 2 * pressure * (1 + STATE["void_ratio"]) / STATE["coordination_number"]
    w = LAW.overlap(force) / (2 * STATE["radius"])
    assert exponents.sum == pytest.approx(1 / 3 - (10 / 9 * w / (1 - w) if rung == 3 else 0), abs=1e-10)


def test_exponents_of_arrays_are_nan_where_there_are_none():
    exponents = granum.exponents(rung=2, modulus="C12", **{**STATE, "tangential_ratio": [0.9, 1.0]})
    assert np.isfinite(exponents.sum).tolist() == [True, False]
    assert exponents.errors == {}


def test_the_ladder_of_a_sand_is_refused_with_a_remedy():
    law = granum.sphere(shear_modulus=44e9, poisson_ratio=0.08, radius=1e-4)
    state = dict(law=law, radius=1e-4, void_ratio=0.7, pressure=1e5)
    with pytest.raises(granum.InvalidArgument, match="sphere for the rungs"):
        granum.estimate(tolerance=0.05, sand="toyoura", **state)
    spheres = granum.estimate(tolerance=0.05, sand="toyoura", grain_shape="sphere", **state)
    assert spheres.rungs[3].estimate.G_vh == granum.estimate(tolerance=0.05, **state).rungs[3].estimate.G_vh


def test_the_ladder_is_that_of_the_program(run_program):
    said = run_program(
        *"estimate --void-ratio 0.6 --coordination-number 5.7 --mechanical-coordination-number 5.9".split(),
        *"--stress-v 100kPa --stress-h 60kPa --fabric 0.1 --tolerance 5%".split(),
        *"--grain-shear-modulus 30GPa --grain-poisson-ratio 0.15".split(),
    )["ladder"]
    ladder = granum.estimate(tolerance=0.05, **STATE)
    assert ladder.choice.rung == said["rung"] == 3
    assert ladder.tolerance_met == said["tolerance_met"]
    assert ladder.advice == said["advice"]
    for rung, row in zip(ladder.rungs, said["rungs"]):
        assert (rung.verdict, rung.reason, rung.missing) == (row["verdict"], row["reason"], row["missing"])
        assert (rung.estimate is None) == (row["moduli"] is None)
        if rung.estimate is not None:
            assert rung.estimate.G_vh == row["moduli"]["G_vh"]
            assert rung.estimate.relative_error.G_vh == row["relative_error"]["G_vh"]


def test_assumed_inputs_make_the_error_larger():
    known = granum.estimate(tolerance=0.05, **STATE)
    without_fabric = {name: value for name, value in STATE.items() if name != "fabric_anisotropy"}
    fabric_assumed = granum.estimate(tolerance=0.05, **without_fabric)
    z_uncertain = granum.estimate(
        tolerance=0.05, uncertainty={"mechanical_coordination_number": 0.2}, **STATE
    )
    assert known.rungs[3].largest_error < fabric_assumed.rungs[3].largest_error
    assert known.rungs[3].largest_error < z_uncertain.rungs[3].largest_error
    assert fabric_assumed.rungs[1].missing and not known.rungs[1].missing
    z, low, high = z_uncertain.mechanical_coordination_number
    assert (low, z, high) == pytest.approx((z - 0.2, z, z + 0.2), rel=2e-3)


def test_uncertainties_are_those_of_the_program(run_program):
    said = run_program(
        *"estimate --void-ratio 0.6 --coordination-number 5.7 --mechanical-coordination-number 5.9".split(),
        *"--stress-v 100kPa --stress-h 60kPa --fabric 0.1 --grain-shear-modulus 30GPa".split(),
        *"--grain-poisson-ratio 0.15 --grain-density 2650kg/m3 --uncertainty void-ratio=0.02".split(),
        *"--uncertainty grain-density=0kg/m3 --uncertainty grain-shear-modulus=2GPa".split(),
    )["answer"]
    found = granum.packing_answer(
        **STATE, grain_density=2650, uncertainty={"void_ratio": 0.02, "grain_shear_modulus": 2e9}
    )
    for key in ("shear_modulus", "bulk_modulus", "shear_wave_speed", "poisson_ratio", "stress_exponent"):
        number = getattr(found, key)
        assert (number.value, number.low, number.high) == tuple(said[key].values())
    with pytest.raises(granum.InvalidArgument, match="slope"):
        granum.packing_answer(**STATE, uncertainty={"slope": 0.1})


def test_the_prior_of_contacts_has_its_ends():
    grains = {"law": LAW, "radius": 0.5e-3, "void_ratio": 0.6, "pressure": 100e3}
    prior = granum.contact_prior(**grains)
    z = [c.mechanical_coordination_number for c in (prior.loosest, prior.middle, prior.densest)]
    assert z[0] < z[1] < z[2]
    for counts in (prior.loosest, prior.densest):
        expected = counts.mechanical_coordination_number * (1 - counts.rattler_fraction)
        assert counts.coordination_number == pytest.approx(expected, rel=1e-15)
    dense = granum.contact_prior(**grains, preparation="dense")
    assert dense.middle.mechanical_coordination_number == pytest.approx(z[2], rel=1e-9)
    with pytest.raises(granum.InvalidArgument, match="quick"):
        granum.contact_prior(**grains, preparation="quick")


def test_contacts_carried_there_and_back_are_the_same():
    grains = {"law": LAW, "radius": 0.5e-3, "void_ratio": 0.6}
    up = granum.carried_contacts(
        **grains, pressure=50e3, mechanical_coordination_number=5.0, rattler_fraction=0.05, to_pressure=500e3
    )
    assert up.counts.mechanical_coordination_number > 5.0 and up.void_ratio < 0.6
    down = granum.carried_contacts(
        law=LAW,
        radius=0.5e-3,
        void_ratio=up.void_ratio,
        pressure=500e3,
        mechanical_coordination_number=up.counts.mechanical_coordination_number,
        rattler_fraction=up.counts.rattler_fraction,
        to_pressure=50e3,
    )
    assert down.counts.mechanical_coordination_number == pytest.approx(5.0, rel=1e-8)
