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


def test_exponents_of_arrays_are_nan_where_there_are_none():
    exponents = granum.exponents(rung=2, modulus="C12", **{**STATE, "tangential_ratio": [0.9, 1.0]})
    assert np.isfinite(exponents.sum).tolist() == [True, False]
    assert exponents.errors == {}


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
