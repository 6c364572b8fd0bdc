# SPDX-License-Identifier: GPL-3.0-or-later
"""Exponents, gradients, uncertainty and the ladder, each against another way to the same number."""

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
    assert exponents.sum == pytest.approx(1 / 3, abs=1e-10)


def test_exponents_of_arrays_are_nan_where_there_are_none():
    exponents = granum.exponents(rung=2, modulus="C12", **{**STATE, "tangential_ratio": [0.9, 1.0]})
    assert np.isfinite(exponents.sum).tolist() == [True, False]
    assert exponents.errors == {}


@pytest.mark.parametrize("rung", RUNGS)
@pytest.mark.parametrize(
    "name", ["void_ratio", "coordination_number", "stress_v", "fabric_anisotropy", "radius"]
)
def test_gradients_are_slopes(rung, name):
    gradient = granum.gradient(rung=rung, modulus="G_vh", **STATE)
    assert gradient.value == pytest.approx(granum.answer(rung=rung, **STATE).G_vh, rel=1e-12)
    assert getattr(gradient, name) * STATE[name] / gradient.value == pytest.approx(
        slope(rung, name), abs=1e-6
    )


def test_gradients_of_arrays_are_those_of_their_elements():
    void_ratios = np.array([0.5, 0.6, -1])
    gradient = granum.gradient(rung=3, modulus="K", **{**STATE, "void_ratio": void_ratios})
    alone = granum.gradient(rung=3, modulus="K", **STATE)
    assert gradient.void_ratio[1] == alone.void_ratio
    assert gradient.mechanical_coordination_number[1] == alone.mechanical_coordination_number != 0
    assert gradient.standard_error[1] == alone.standard_error > 0
    assert np.isnan(gradient.void_ratio[2]) and list(gradient.errors) == [(2,)]


@pytest.mark.parametrize("rung", RUNGS)
def test_uncertainty_is_gradient_times_deviation(rung):
    gradient = granum.gradient(rung=rung, modulus="G_vh", **STATE)
    found = granum.uncertainty(
        rung=rung, modulus="G_vh", deviations={"void_ratio": 0.01, "stress_v": 3e3}, **STATE
    )
    parts = [gradient.void_ratio * 0.01, gradient.stress_v * 3e3, gradient.standard_error]
    assert found.value == pytest.approx(gradient.value, rel=1e-12)
    assert found.deviation == pytest.approx(np.linalg.norm(parts), rel=1e-12)
    assert found.contributions == pytest.approx({"void_ratio": parts[0], "stress_v": parts[1]}, rel=1e-12)
    assert sum(found.shares.values()) + (found.calibration / found.deviation) ** 2 == pytest.approx(
        1, rel=1e-12
    )
    # a sample of 4,096 draws knows the deviation to some per cent
    assert found.sampled.deviation == pytest.approx(found.deviation, rel=0.06)
    assert found.sampled.low < found.sampled.median < found.sampled.high
    again = granum.uncertainty(
        rung=rung, modulus="G_vh", deviations={"void_ratio": 0.01, "stress_v": 3e3}, seed=2, **STATE
    )
    assert again.sampled.mean != found.sampled.mean


def test_uncertainty_names_what_is_wrong():
    with pytest.raises(granum.InvalidArgument, match="porosity is none of the inputs mean_stress"):
        granum.uncertainty(rung=2, modulus="K", deviations={"porosity": 0.1}, **STATE)
    with pytest.raises(granum.InvalidArgument, match="modulus is one of"):
        granum.uncertainty(rung=2, modulus="M", deviations={}, **STATE)
    with pytest.raises(TypeError, match="takes one packing"):
        granum.uncertainty(rung=2, modulus="K", deviations={}, **{**STATE, "void_ratio": [0.5, 0.6]})


def test_the_ladder_is_that_of_the_program(run_program):
    said = run_program(
        *"estimate --void-ratio 0.6 --coordination-number 5.7 --mechanical-coordination-number 5.9".split(),
        *"--stress-v 100kPa --stress-h 60kPa --fabric 0.1 --tolerance 5%".split(),
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


def test_what_is_not_measured_makes_the_error_larger():
    known = granum.estimate(tolerance=0.05, **STATE)
    fabric_assumed = granum.estimate(tolerance=0.05, fabric_standard_error=None, **STATE)
    z_uncertain = granum.estimate(tolerance=0.05, coordination_error=0.2, **STATE)
    assert known.rungs[3].largest_error < fabric_assumed.rungs[3].largest_error
    assert known.rungs[3].largest_error < z_uncertain.rungs[3].largest_error
    assert z_uncertain.mechanical_coordination_number.standard_error == 0.2
    alone = {name: value for name, value in STATE.items() if name != "mechanical_coordination_number"}
    assert granum.estimate(tolerance=0.05, **alone).coordination_estimated


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
