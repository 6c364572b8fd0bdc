# SPDX-License-Identifier: GPL-3.0-or-later
"""What errors name: the argument as it was typed, and the kind that it should have been."""

import numpy as np
import pytest

import granum

LAW = granum.sphere(shear_modulus=30e9, poisson_ratio=0.15, radius=0.5e-3)
STATE = dict(law=LAW, radius=0.5e-3, void_ratio=0.6, coordination_number=5.7, pressure=1e5)
PRIOR = dict(law=LAW, radius=0.5e-3, void_ratio=0.6, pressure=1e5)
INFER = {**PRIOR, "V_s": 300.0, "relative_error": 0.02, "grain_density": 2650.0}
BATCH = dict(law=LAW, radius=0.5e-3, porosity=0.375, coordination_number=5.7, pressure=1e5)
SPHERE = dict(shear_modulus=30e9, poisson_ratio=0.15, porosity=0.36, coordination_number=8.0, pressure=1e6)
SAND = {**SPHERE, "critical_porosity": 0.36, "porosity": 0.3}
SPECIMEN = dict(kind="dense", law=LAW, radius=0.5e-3, friction_coefficient=0.5, grains=60, seed=1)


def packing():
    return granum.packing(position=[[0, 0, 0], [0.9e-3, 0, 0]], radius=0.5e-3, cell=[4e-3] * 3, contacts=[[0, 1]])


# function, good arguments, those that are to be objects of another kind, and what must be named
KINDS = [
    (granum.uniform_strain, STATE, {"law": "contact law", "contact_means": "ContactMeans", "strict": "True"}),
    (
        granum.relaxed,
        {**STATE, "rattler_fraction": 0.02},
        {"law": "contact law", "contact_means": "ContactMeans"},
    ),
    (
        granum.packing_answer,
        PRIOR,
        {"law": "contact law", "contact_means": "ContactMeans", "preparation": "string", "uncertainty": "dict"},
    ),
    (
        granum.contact_prior,
        PRIOR,
        {"law": "contact law", "contact_means": "ContactMeans", "preparation": "string"},
    ),
    (granum.infer, INFER, {"law": "contact law", "contact_means": "ContactMeans"}),
    (
        granum.uniform_strain_moduli,
        BATCH,
        {"law": "contact law", "contact_means": "ContactMeans", "strict": "True"},
    ),
    (granum.hertz_mindlin, SPHERE, {"strict": "True"}),
    (
        granum.specimen,
        SPECIMEN,
        {"law": "contact law", "kind": "string", "grains": "whole", "seed": "whole", "sizes": "Distribution"},
    ),
    (
        granum.measure,
        {"packing": None},
        {
            "packing": "Packing",
            "law": "contact law",
            "materials": "dict",
            "stiffness_from": "string",
            "network": "True",
            "prestress": "True",
        },
    ),
    (granum.packing, dict(position=[[0, 0, 0]], radius=1e-3, cell=[1, 1, 1]), {"periodic": "three"}),
    (granum.compress, dict(specimen=None, pressures=[1e5]), {"specimen": "Specimen"}),
    (granum.probe, dict(specimen=None, mode="vh"), {"specimen": "Specimen"}),
    (
        granum.shear,
        dict(specimen=None, path="TXC", mean_stress=1e5),
        {"specimen": "Specimen", "path": "string"},
    ),
]


class Another:
    """No number, no string, no sequence, no dict, and neither true nor false."""

    def __bool__(self):
        raise ValueError("neither")


@pytest.mark.parametrize(("function", "good", "kinds"), KINDS, ids=[row[0].__name__ for row in KINDS])
def test_an_object_of_another_kind_is_named_with_the_kind_that_it_should_be(function, good, kinds):
    good = {name: packing() if name == "packing" else value for name, value in good.items()}
    for name, kind in kinds.items():
        for wrong in (Another(), [Another()], 1.5, "\ud800"):
            if (kind == "True" and wrong == 1.5) or (kind == "string" and isinstance(wrong, str)):
                continue  # is one of its kind
            with pytest.raises(TypeError) as error:
                function(**{**good, name: wrong})
            assert name in str(error.value) and kind in str(error.value), (name, wrong, str(error.value))
            assert function.__name__ in str(error.value)


def test_none_in_the_place_of_an_object_is_named_too():
    for function, good, name in (
        (granum.uniform_strain, STATE, "law"),
        (granum.compress, dict(pressures=[1e5]), "specimen"),
        (granum.probe, dict(mode="vh"), "specimen"),
        (granum.measure, {}, "packing"),
    ):
        with pytest.raises(TypeError, match=name):
            function(**{**good, name: None})


# function, good arguments, and a number out of its range for each argument
RANGES = [
    (
        granum.uniform_strain,
        STATE,
        dict(
            radius=0.0,
            void_ratio=-1.0,
            coordination_number=-1.0,
            pressure=-1.0,
            fabric_anisotropy=9.0,
            tangential_ratio=-1.0,
        ),
    ),
    (
        granum.relaxed,
        {**STATE, "mechanical_coordination_number": 6.0},
        dict(pressure=-1.0, mechanical_coordination_number=-1.0),
    ),
    (granum.relaxed, {**STATE, "rattler_fraction": 0.02}, dict(rattler_fraction=1.5)),
    (
        granum.packing_answer,
        PRIOR,
        dict(
            radius=0.0,
            void_ratio=-1.0,
            pressure=-1.0,
            grain_density=0.0,
            saturation=2.0,
            rattler_fraction=1.5,
        ),
    ),
    (granum.contact_prior, PRIOR, dict(radius=0.0, void_ratio=-1.0, pressure=-1.0)),
    (
        granum.carried_contacts,
        {**PRIOR, "mechanical_coordination_number": 5.0, "rattler_fraction": 0.02, "to_pressure": 2e5},
        dict(pressure=-1.0, to_pressure=-1.0, rattler_fraction=2.0, mechanical_coordination_number=-1.0),
    ),
    (granum.infer, INFER, dict(radius=0.0, void_ratio=-1.0, pressure=-1.0)),
    (
        granum.hertz_mindlin,
        SPHERE,
        dict(
            shear_modulus=0.0,
            poisson_ratio=0.6,
            porosity=1.5,
            coordination_number=-1.0,
            pressure=-1.0,
            no_slip_fraction=2.0,
        ),
    ),
    (granum.soft_sand, SAND, dict(critical_porosity=1.3, porosity=0.4, pressure=-1.0)),
    (granum.stiff_sand, SAND, dict(critical_porosity=0.0, porosity=-0.1, shear_modulus=0.0)),
]


@pytest.mark.parametrize(("function", "good", "wrong"), RANGES, ids=[row[0].__name__ for row in RANGES])
def test_a_number_out_of_range_is_named_as_it_was_typed(function, good, wrong):
    for name, value in wrong.items():
        with pytest.raises(granum.InvalidArgument) as error:
            function(**{**good, name: value})
        assert (error.value.name, error.value.value) == (name, value), str(error.value)
        assert str(error.value).startswith(f"{name} = ")


def test_both_stresses_keep_their_names_and_arrays_name_the_typed_argument():
    stresses = {name: value for name, value in STATE.items() if name != "pressure"}
    for name in ("stress_v", "stress_h"):
        with pytest.raises(granum.InvalidArgument) as error:
            granum.uniform_strain(**stresses, **{**dict(stress_v=1e5, stress_h=5e4), name: -1.0})
        assert error.value.name == name
    errors = granum.uniform_strain(**{**STATE, "pressure": np.array([1e5, -1.0])}).errors
    assert list(errors) == [(1,)] and errors[(1,)].startswith("pressure = ")


def test_laws_name_the_material_as_it_was_typed():
    with pytest.raises(granum.InvalidArgument, match="^shear_modulus = -1 "):
        granum.sphere(shear_modulus=-1, poisson_ratio=0.15, radius=0.5e-3)
    with pytest.raises(granum.InvalidArgument, match="^poisson_ratio = 0.6 "):
        granum.cone(shear_modulus=30e9, poisson_ratio=0.6, slope=0.4)


@pytest.mark.parametrize("function", [granum.packing_answer, granum.contact_prior])
def test_a_packing_is_not_below_the_pressure_of_its_preparation(function):
    assert function(**PRIOR, preparation="dense:100kPa")
    with pytest.raises(granum.InvalidArgument, match=r"pressure of preparation = 200000 Pa is outside \(0, 100 kPa\]"):
        function(**PRIOR, preparation="dense:200kPa")
