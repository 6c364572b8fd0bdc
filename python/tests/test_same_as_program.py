# SPDX-License-Identifier: GPL-3.0-or-later
"""Python and the program say the same, to the bit: both ask one library."""

import random

import granum
import pytest

MATERIALS = {"sphere": {}, "cone": {"slope": 0.4}, "flat": {"punch_radius": 2e-5}}
MAKERS = {"sphere": granum.sphere, "cone": granum.cone, "flat": granum.flat_punch}


def random_state(rng):
    contact = rng.choice(list(MATERIALS))
    state = {
        "radius": 10 ** rng.uniform(-4, -2),
        "void_ratio": rng.uniform(0.4, 1.0),
        "coordination_number": rng.uniform(3, 9),
        "fabric_anisotropy": rng.uniform(-0.5, 0.5),
        "stress_v": 10 ** rng.uniform(3, 6),
        "mechanical_coordination_number": rng.uniform(4.2, 8),
    }
    state["stress_h"] = state["stress_v"] * rng.uniform(0.4, 2)
    if rng.random() < 0.5:
        state["tangential_ratio"] = rng.uniform(0, 1)
    grain = {"shear_modulus": 10 ** rng.uniform(9, 11), "poisson_ratio": rng.uniform(0, 0.45)}
    return contact, grain, state


def options_of(contact, grain, state):
    units = {"radius": "m", "stress_v": "Pa", "stress_h": "Pa", "punch_radius": "m"}
    names = {"fabric_anisotropy": "fabric"}
    options = ["--contact", contact]
    options += ["--grain-shear-modulus", f"{grain['shear_modulus']!r}Pa"]
    options += ["--grain-poisson-ratio", repr(grain["poisson_ratio"])]
    for name, value in {**state, **MATERIALS[contact]}.items():
        option = "--" + names.get(name, name).replace("_", "-")
        options += [f"{option}={value!r}{units.get(name, '')}"]
    return options


def law_of(contact, grain, state):
    shape = {"radius": state["radius"]} if contact == "sphere" else MATERIALS[contact]
    return MAKERS[contact](**grain, **shape)


FORMS = {
    "uniform_strain": granum.uniform_strain,
    "uniform_stress": granum.uniform_stress,
    "relaxed": granum.relaxed,
}
KEYS = {
    "K": "bulk_modulus",
    **{key: key for key in ("C11", "C33", "C12", "C13", "C44", "C66", "G_hh", "G_vh", "E_v", "E_h")},
}


SANDS = {
    "a void ratio alone": ({"void_ratio": 0.71}, ["--void-ratio=0.71"]),
    "a grading": ({"void_ratio": 0.6, "uniformity": 3.1}, ["--void-ratio=0.6", "--uniformity=3.1"]),
    "a name": ({"void_ratio": 0.75, "sand": "toyoura"}, ["--void-ratio=0.75", "--sand=toyoura"]),
}


def as_program_says(number):
    """NaN of Python is null in JSON."""
    return None if number != number else number


@pytest.mark.parametrize("seed", range(200))
def test_estimate_is_the_same_to_the_bit(run_program, seed):
    contact, grain, state = random_state(random.Random(seed))
    law = law_of(contact, grain, state)
    said = run_program("estimate", *options_of(contact, grain, state))
    for name, form in FORMS.items():
        estimate = form(law=law, **state)
        for key, attribute in KEYS.items():
            assert as_program_says(getattr(estimate, attribute)) == said[name][key], (name, key)
    error = granum.relaxed(law=law, **state).relative_error
    assert [error.bulk_modulus, error.G_vh, error.G_hh] == [
        said["relaxed"]["relative_error"][k] for k in ("K", "G_vh", "G_hh")
    ]


def test_measure_is_the_same_to_the_bit(run_program, dump, packing, sphere):
    frame = run_program("analyse", *dump, "--grain-shear-modulus", "30GPa", "--grain-poisson-ratio", 0.15)[
        "frames"
    ][0]
    found = granum.measure(packing, law=sphere)
    assert found.network.relaxed.tolist() == frame["network"]["relaxed"]["C"]
    assert found.network.affine.tolist() == frame["network"]["affine"]["C"]
    places = {"xx": (0, 0), "yy": (1, 1), "zz": (2, 2), "xy": (1, 0), "xz": (2, 0), "yz": (2, 1)}
    for key, place in places.items():
        assert found.stress.tensor[place] == frame["stress"]["by_contacts"][key]
    assert found.fabric.tensor.tolist() == frame["fabric"]["tensor"]
    assert found.fabric.anisotropy == frame["fabric"]["anisotropy"]
    counts = frame["counts"]
    assert found.counts.coordination_number == counts["coordination_number"]
    assert found.counts.mechanical_coordination_number == counts["mechanical_coordination_number"]
    assert found.void_ratio == frame["void_ratio"]
    assert found.rungs["rung3"].G_vh == frame["moduli"]["rung3"]["G_vh"]
    assert found.warnings == frame["warnings"]


def test_a_law_that_is_not_given_is_derived_from_the_forces(run_program, dump, packing):
    frame = run_program("analyse", *dump, "--no-network")["frames"][0]
    found = granum.measure(packing, network=False)
    assert found.network is None
    assert found.law.shear_modulus == frame["grain"]["shear_modulus"]


@pytest.mark.parametrize("sand", SANDS)
@pytest.mark.parametrize("stresses", [(100e3, 100e3), (217e3, 91e3)])
def test_a_sand_is_the_same_to_the_bit(run_program, sand, stresses):
    numbers, options = SANDS[sand]
    v, h = stresses
    grain = {"shear_modulus": 44e9, "poisson_ratio": 0.074}
    state = ["--grain-shear-modulus=44e9Pa", "--grain-poisson-ratio=0.074", "--radius=1e-4m", "--strain=2e-4"]
    said = run_program("estimate", *options, *state, f"--stress-v={v!r}Pa", f"--stress-h={h!r}Pa")["answer"]
    answer = granum.packing_answer(
        law=granum.sphere(**grain, radius=1e-4),
        radius=1e-4,
        stress_v=v,
        stress_h=h,
        grain_density=2650,
        shear_strain=2e-4,
        grain_shape="sand",
        **numbers,
    )
    # Contacts are counted on equal spheres: the gradation of the program's grains moves them by rounding alone.
    for key in ("mechanical_coordination_number", "contact_softness", "slip_strain"):
        assert getattr(answer, key).value == pytest.approx(said[key]["value"], rel=1e-9), key
    for key in ("shear_modulus", "young_modulus", "bulk_modulus", "poisson_ratio", "shear_wave_speed",
                "compression_wave_speed", "stress_exponent", "strained_shear_modulus", "damping_ratio"):
        for end in ("value", "low", "high"):
            assert getattr(getattr(answer, key), end) == said[key][end], (key, end)
