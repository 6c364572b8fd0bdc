# SPDX-License-Identifier: GPL-3.0-or-later
"""The best answer with its range, and the contacts that measurements imply: as the program says them."""

import granum
import numpy as np
import pytest

LAW = granum.sphere(shear_modulus=26e9, poisson_ratio=0.22, radius=0.5e-3)
BEADS = {"law": LAW, "radius": 0.5e-3, "void_ratio": 0.58}
OPTIONS = ["--grain-shear-modulus", "26GPa", "--grain-poisson-ratio", "0.22", "--radius", "0.5mm"]
OPTIONS += ["--void-ratio", "0.58", "--grain-density", "2500kg/m3"]

KNOWN = [
    {},
    {"preparation": "dense"},
    {"preparation": "friction:0.3"},
    {"rattler_fraction": 0.03},
    {"coordination_number": 5.1},
    {"mechanical_coordination_number": 4.9, "saturation": 1.0},
    {"fabric_anisotropy": 0.1},
]


@pytest.mark.parametrize("known", KNOWN, ids=lambda known: ",".join(known) or "nothing")
def test_the_answer_is_that_of_the_program(run_program, known):
    more = []
    for name, value in known.items():
        more += ["--" + {"fabric_anisotropy": "fabric"}.get(name, name).replace("_", "-"), str(value)]
    said = run_program("estimate", *OPTIONS, "--pressure", "100kPa", *more)["answer"]
    found = granum.packing_answer(**BEADS, pressure=100e3, grain_density=2500, **known)
    compared = 0
    for name in ("shear_modulus", "bulk_modulus", "young_modulus", "poisson_ratio", "shear_wave_speed"):
        for part in ("value", "low", "high"):
            assert getattr(getattr(found, name), part) == said[name][part], (name, part)
            compared += 1
    assert compared == 15


def test_the_answer_is_broadcast():
    pressure = np.array([[50e3], [100e3]])
    void_ratio = np.array([0.58, 0.66, -1.0])
    found = granum.packing_answer(law=LAW, radius=0.5e-3, void_ratio=void_ratio, pressure=pressure)
    assert found.shape == (2, 3)
    one = granum.packing_answer(law=LAW, radius=0.5e-3, void_ratio=0.66, pressure=100e3)
    assert found.shear_modulus.high[1, 1] == one.shear_modulus.high
    assert found.shares["contacts"][1, 1] == one.shares["contacts"]
    assert sum(one.shares.values()) == pytest.approx(1)
    assert np.isnan(found.shear_modulus.value[:, 2]).all()
    assert set(found.errors) == {(0, 2), (1, 2)} and "void_ratio" in found.errors[0, 2]
    assert np.isnan(one.shear_wave_speed.value)  # no density was given


def test_infer_is_that_of_the_program(run_program):
    measured = ["--vs", "320m/s", "--vp", "530m/s", "--measurement-error", "2%"]
    said = run_program("infer", *OPTIONS, "--fabric", "0", "--pressure", "100kPa", *measured)
    found = granum.infer(
        **BEADS, pressure=100e3, V_s=320, V_p=530, relative_error=0.02, grain_density=2500, pore_density=0
    )
    for name in ("mechanical_coordination_number", "rattler_fraction", "coordination_number"):
        measured = getattr(found, name)
        assert measured.value == said["answer"][name]["value"]
    assert found.chi_square == said["chi_square"]
    assert found.pressure == said["reference_stress"] == 100e3


def test_contacts_that_speeds_imply_are_those_of_the_program(run_program, tmp_path):
    table = tmp_path / "speeds.csv"
    table.write_text("p_kPa,e,V_s_m/s,V_p_m/s\n50,0.6,200,330\n100,0.6,232,379\n200,0.6,268,434\n")
    place = OPTIONS.index("--void-ratio")
    options = OPTIONS[:place] + OPTIONS[place + 2 :]
    said = run_program(
        "infer", "--table", table, *options, "--fabric", "0", "--measurement-error", "2%", "--contacts", "power-law"
    )
    beads = {key: value for key, value in BEADS.items() if key != "void_ratio"}
    measured = {"pressure": [50e3, 100e3, 200e3], "V_s": [200, 232, 268], "V_p": [330, 379, 434]}
    found = granum.infer(
        **beads, void_ratio=0.6, **measured, relative_error=0.02, grain_density=2500, contacts="power-law"
    )
    numbers = {number["key"]: number for number in said["contacts"]["numbers"]}
    assert list(found.contact_numbers) == list(numbers) == ["z*", "softness", "alpha"]
    for key, number in found.contact_numbers.items():
        assert number.value == numbers[key]["value"]
        assert (key in found.undetermined) == (not numbers[key]["determined"])
    assert found.would_determine == said["contacts"]["would_determine"]
    assert found.contact_law.alpha == pytest.approx(found.contact_numbers["alpha"].value, rel=1e-12)
    assert granum.infer(**beads, void_ratio=0.6, **measured, relative_error=0.02, grain_density=2500).contact_law is None
    with pytest.raises(granum.InvalidArgument, match="cubes"):
        granum.infer(**BEADS, pressure=1e5, G=150e6, relative_error=0.02, contacts="cubes")


def test_errors_that_all_measurements_share_are_those_of_the_program(run_program):
    state = ("--pressure", "100kPa", "--vs", "250m/s+-2%", "--fabric", "0", "--tangential-ratio", 0.8)
    stated = {"grain_shear_modulus": 2e9, "void_ratio": 0.01, "grain_density": 50.0}
    options = ["grain-shear-modulus=2GPa", "void-ratio=0.01", "grain-density=50kg/m3"]
    said = run_program(
        "infer", *OPTIONS, *state, "--grain-shape", "sphere", *(f"--uncertainty={option}" for option in options)
    )
    measured = dict(pressure=100e3, V_s=250, relative_error=0.02, grain_density=2500, tangential_ratio=0.8)
    found = granum.infer(**BEADS, **measured, uncertainty=stated)
    contacts = said["answer"]["mechanical_coordination_number"]
    z = found.mechanical_coordination_number
    assert z.value == pytest.approx(contacts["value"], rel=1e-12)
    assert z.standard_error == pytest.approx(contacts["standard_error"], rel=1e-9)
    alone = granum.infer(**BEADS, **measured).mechanical_coordination_number
    assert z.standard_error > 1.1 * alone.standard_error
    with pytest.raises(granum.InvalidArgument, match="colour"):
        granum.infer(**BEADS, **measured, uncertainty={"colour": 1})


def test_a_hole_in_the_measurements_is_left_out():
    whole = granum.infer(**BEADS, pressure=[1e5], G=[150e6], relative_error=0.02)
    holes = granum.infer(
        **BEADS, pressure=[1e5, 2e5], G=[150e6, np.nan], K=[np.nan, np.nan], relative_error=0.02
    )
    a, b = whole.mechanical_coordination_number, holes.mechanical_coordination_number
    assert (a.value, a.standard_error) == (b.value, b.standard_error)
    with pytest.raises(granum.InvalidArgument, match="G"):
        granum.infer(**BEADS, pressure=1e5, G=np.nan, relative_error=0.02)


def test_measurements_that_no_contacts_explain_are_reported():
    stiff = granum.infer(**BEADS, pressure=1e5, G=9e9, relative_error=0.02)
    assert not stiff.explained and stiff.alone == [None] and stiff.notes
    with pytest.raises(granum.NotConverged):
        stiff.mechanical_coordination_number
    with pytest.raises(granum.InvalidArgument, match="sound"):
        granum.infer(**BEADS, pressure=1e5, G=150e6, relative_error=0.02).predict("sound", pressure=1e5)


def test_cement_is_that_of_the_program(run_program):
    words = "estimate --void-ratio 0.7 --pressure 100kPa --sand toyoura --cement 2%"
    said = run_program(*words.split())
    grain = said["inputs"]
    cemented = granum.cement_at_contacts(
        shear_modulus=grain["grain_shear_modulus"],
        poisson_ratio=grain["grain_poisson_ratio"],
        cement_shear_modulus=grain["grain_shear_modulus"],
        cement_poisson_ratio=grain["grain_poisson_ratio"],
        porosity=0.7 / 1.7,
        coordination_number=said["cemented"]["coordination_number"],
        cement_saturation=0.02 / (0.7 / 1.7),
    )
    assert cemented.shear_modulus == pytest.approx(said["cemented"]["at_contacts"]["shear_modulus"], rel=1e-12)
