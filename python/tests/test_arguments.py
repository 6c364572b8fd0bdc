# SPDX-License-Identifier: GPL-3.0-or-later
"""Every argument of every function and method: its signature, and its name, value and range in errors."""

import inspect

import granum
import numpy as np
import pytest

SOLID = dict(shear_modulus=30e9, poisson_ratio=0.15)
LAW = granum.sphere(**SOLID, radius=0.5e-3)
GRAINS = dict(law=LAW, radius=0.5e-3, void_ratio=0.6, pressure=1e5)
STATE = dict(**GRAINS, coordination_number=5.7)
SPHERES = dict(**SOLID, porosity=0.36, coordination_number=8.0)
PRESSED = dict(**SPHERES, pressure=1e6)
BOUND = dict(PRESSED, critical_porosity=0.36, porosity=0.3)
STRAINED = dict(**SPHERES, uniaxial_strain=1e-4)
CEMENT = dict(**SPHERES, cement_shear_modulus=5e9, cement_poisson_ratio=0.3, cement_saturation=0.1)
STIFFNESS = granum.isotropic(bulk_modulus=2e8, shear_modulus=1e8).stiffness
NORMALS = granum.sample_normals(anisotropy=0.3, count=50, seed=2)
TWO = dict(position=[[0, 0, 0], [0.9e-3, 0, 0]], radius=0.5e-3, cell=[4e-3] * 3, contacts=[[0, 1]])
SPECIMEN = dict(law=LAW, radius=0.5e-3, friction_coefficient=0.5, kind="dense", grains=40, seed=1)

# Arguments that each function answers.
GOOD = {
    "answer": dict(**STATE, rung=2),
    "bulk_density": dict(grain_density=2650.0, void_ratio=0.6),
    "carried_contacts": dict(
        **GRAINS, mechanical_coordination_number=5.0, rattler_fraction=0.02, to_pressure=2e5
    ),
    "cement_at_contacts": CEMENT,
    "cement_in_surface_layer": CEMENT,
    "cone": dict(**SOLID, slope=0.4),
    "contact_law": dict(shape="cone", **SOLID, slope=0.4),
    "contact_prior": GRAINS,
    "digby": dict(**PRESSED, bond_radius_ratio=0.1),
    "engineering_moduli": dict(stiffness=STIFFNESS),
    "estimate": dict(**GRAINS, tolerance=0.5),
    "estimate_anisotropy": dict(normals=NORMALS),
    "estimate_anisotropy_by_likelihood": dict(normals=NORMALS),
    "expected_contact_means": dict(sizes=granum.Distribution("lognormal:0.3")),
    "exponents": dict(**STATE, rung=1, modulus="G_vh"),
    "fabric_cumulative_probability": dict(polar_cosine=0.3, anisotropy=0.2),
    "fabric_density": dict(polar_angle=0.3, anisotropy=0.2),
    "fabric_measures": dict(F33=0.4),
    "fabric_polar_cosine_quantile": dict(probability=0.3, anisotropy=0.2),
    "failure_ratio": dict(path="rtxe", friction_angle=0.5),
    "fit": dict(
        shear_modulus=[1e8, 1.4e8, 1.9e8, 1.7e8],
        stress_i=[1e5, 2e5, 4e5, 2e5],
        stress_j=[1e5, 2e5, 4e5, 4e5],
        void_ratio=0.6,
        atmospheric_pressure=1e5,
    ),
    "flat_punch": dict(**SOLID, punch_radius=1e-5),
    "free_spin": STATE,
    "gradation": dict(radius=[1e-3, 2e-3]),
    "ground_stress": dict(depth=5.0, unit_weight=18e3, earth_pressure_at_rest=0.5),
    "hardin": dict(
        coefficient=500.0,
        exponent_i=0.25,
        exponent_j=0.25,
        atmospheric_pressure=1e5,
        stress_i=1e5,
        stress_j=2e5,
        void_ratio=0.6,
    ),
    "hertz_mindlin": PRESSED,
    "infer": dict(**GRAINS, V_s=300.0, relative_error=0.02, grain_density=2650.0),
    "isotropic": dict(bulk_modulus=2e8, shear_modulus=1e8),
    "isotropic_averages": dict(stiffness=STIFFNESS),
    "isotropic_projection": dict(stiffness=STIFFNESS),
    "isotropy_p_value": dict(normals=NORMALS),
    "jenkins_shear_modulus": PRESSED,
    "lowest_modes": dict(packing=granum.packing(**TWO), law=LAW, count=1, grain_density=2650.0),
    "measure": dict(packing=granum.packing(**TWO)),
    "mindlin_stiffness_ratio": dict(poisson_ratio=0.15),
    "murphy_coordination_number": dict(porosity=0.36, relation="table"),
    "norris_johnson": dict(**STRAINED, hydrostatic_strain=1e-4),
    "norris_johnson_stress": dict(**STRAINED, hydrostatic_strain=1e-4, path="simultaneous"),
    "overlap_contacts": dict(packing=granum.packing(**TWO)),
    "packing": TWO,
    "packing_answer": GRAINS,
    "pair_radius": dict(radius_i=1e-3, radius_j=2e-3),
    "plane_waves": dict(stiffness=STIFFNESS, bulk_density=1600.0, direction=[0, 0, 1]),
    "power_law": dict(**SOLID, alpha=3.0, profile_constant=1e6),
    "d2min": dict(before=granum.packing(**TWO), after=granum.packing(**TWO)),
    "profile": dict(packing=granum.packing(**TWO)),
    "relaxed": dict(**STATE, rattler_fraction=0.02),
    "rose": dict(normals=NORMALS, anisotropy=0.2, bins=5),
    "rotate": dict(stiffness=STIFFNESS, rotation=np.eye(3)),
    "rough_sphere": dict(**SOLID, radius=0.5e-3, roughness=1e-7),
    "sample_normals": dict(anisotropy=0.2, count=5, seed=1),
    "sand_shear_modulus": dict(law="menq", void_ratio=0.6, pressure=1e5),
    "saturated": dict(stiffness=STIFFNESS, grain_bulk_modulus=37e9, fluid_bulk_modulus=2.2e9, void_ratio=0.6),
    "soft_sand": BOUND,
    "specimen": SPECIMEN,
    "sphere": dict(**SOLID, radius=0.5e-3),
    "stiff_sand": BOUND,
    "stiffness_matrix": dict(packing=granum.packing(**TWO), law=LAW),
    "stress_on_path": dict(path="txc", pressure=1e5, eta=0.5),
    "symmetry_distances": dict(stiffness=STIFFNESS),
    "thomsen_parameters": dict(stiffness=STIFFNESS),
    "transversely_isotropic_projection": dict(stiffness=STIFFNESS),
    "uniform_strain": STATE,
    "uniform_strain_kinematic": STATE,
    "uniform_strain_moduli": dict(
        law=LAW, radius=0.5e-3, porosity=0.375, coordination_number=5.7, pressure=1e5
    ),
    "uniform_stress": STATE,
    "uniform_stress_kinematic": STATE,
    "void_ratio_of_relative_density": dict(
        relative_density=0.5, least_void_ratio=0.6, largest_void_ratio=0.98
    ),
    "walton_uniaxial": STRAINED,
    "walton_uniaxial_stress": STRAINED,
    "water_and_air_bulk_modulus": dict(saturation=0.5),
    "write_vtk": dict(packing=granum.packing(**TWO), path="/nowhere/grains.vtu"),
}
WITHOUT_ARGUMENTS = {"formats", "known_sands", "measured_laws", "minerals", "references", "rungs"}
# Written in Python, or of a specimen, which takes seconds to prepare.
OTHERS = {"compress", "frames", "from_lammps", "from_yade", "probe", "read", "shear", "verify"}


def test_all_functions_are_here():
    functions = {name for name in granum.__all__ if inspect.isroutine(getattr(granum, name))}
    assert functions == {*GOOD, *WITHOUT_ARGUMENTS, *OTHERS}


class Nothing:
    """Of no kind that a function takes."""

    def __bool__(self):
        raise ValueError("neither")


@pytest.mark.parametrize("name", GOOD)
def test_an_object_of_another_kind_and_none_are_named(name):
    function, good = getattr(granum, name), GOOD[name]
    assert set(good) <= set(inspect.signature(function).parameters)
    for argument, parameter in inspect.signature(function).parameters.items():
        if argument == "rung":  # any text
            continue
        wrongs = [Nothing()] if parameter.default is not parameter.empty else [Nothing(), None]
        for wrong in wrongs:
            rest = {key: value for key, value in good.items() if argument != "bulk_modulus" or key != "poisson_ratio"}
            with pytest.raises((TypeError, granum.InvalidArgument)) as error:
                function(**{**rest, argument: wrong})
            assert argument.split("_")[-1] in str(error.value), (argument, wrong, str(error.value))


# Refused as rows of a table, with their numbers.
OF_ROWS = {"fit", "gradation", "infer", "packing"}


@pytest.mark.parametrize("name", sorted(GOOD.keys() - OF_ROWS))
def test_a_number_that_is_none_is_refused_with_its_name_value_and_range(name):
    function, good = getattr(granum, name), GOOD[name]
    for argument, value in good.items():
        if not isinstance(value, float):
            continue
        with pytest.raises(granum.InvalidArgument) as error:
            function(**{**good, argument: float("nan")})
        said = str(error.value)
        assert said.startswith((f"{argument} = nan", f"{argument} = -nan")), (argument, said)
        if name != "uniform_strain_moduli":  # whose errors are messages of a batch
            assert error.value.name == argument and error.value.range


def test_methods_have_signatures_and_name_their_arguments():
    sizes = granum.Distribution("lognormal:0.3")
    for method in (LAW.force, sizes.share_below, granum.ContactMeans().with_reference):
        (first, *_) = inspect.signature(method).parameters
        with pytest.raises(TypeError, match=first):
            method("x")
        with pytest.raises(TypeError, match="colour"):
            method(1.0, colour=1)
    assert list(inspect.signature(granum.NormalLaw.force).parameters) == ["self", "overlap"]
    assert inspect.signature(sizes.quantile).parameters["k"].default == 0.0


MAKERS = {"sphere": "sphere", "cone": "cone", "flat": "flat_punch", "power-law": "power_law", "rough": "rough_sphere"}


@pytest.mark.parametrize("shape", MAKERS)
def test_a_law_by_name_is_that_of_its_maker_and_takes_its_numbers_only(shape):
    make, numbers = getattr(granum, MAKERS[shape]), GOOD[MAKERS[shape]]
    assert repr(granum.contact_law(shape, **numbers)) == repr(make(**numbers))
    (*_, own) = numbers
    with pytest.raises(TypeError, match=own):
        granum.contact_law(shape, **{name: value for name, value in numbers.items() if name != own})
    with pytest.raises(TypeError, match="colour"):
        granum.contact_law(shape, **numbers, colour=1)


@pytest.mark.parametrize("shape", MAKERS)
def test_a_bulk_modulus_replaces_poissons_ratio(shape):
    make = getattr(granum, MAKERS[shape])
    rest = {name: value for name, value in GOOD[MAKERS[shape]].items() if name != "poisson_ratio"}
    law = make(**rest, poisson_ratio=0.2)
    assert law.bulk_modulus == pytest.approx(40e9, rel=1e-14)
    assert make(**rest, bulk_modulus=40e9).force(1e-6) == pytest.approx(law.force(1e-6), rel=1e-12)
    for wrong in (dict(poisson_ratio=0.2, bulk_modulus=40e9), {}):
        with pytest.raises(TypeError, match="bulk_modulus"):
            make(**rest, **wrong)
    with pytest.raises(granum.InvalidArgument, match="bulk_modulus = -1"):
        make(**rest, bulk_modulus=-1)


def test_bulk_moduli_of_models_broadcast():
    K, G = np.array([[30e9], [37e9]]), 44e9
    rest = dict(shear_modulus=G, porosity=0.36, coordination_number=9, pressure=[1e6, 1e7, 2e7])
    found = granum.hertz_mindlin(**rest, bulk_modulus=K)
    same = granum.hertz_mindlin(**rest, poisson_ratio=(3 * K - 2 * G) / (2 * (3 * K + G)))
    assert found.shear_modulus.shape == (2, 3)
    np.testing.assert_allclose(found.shear_modulus, same.shear_modulus, rtol=1e-13)


def test_both_stresses_keep_their_names_and_arrays_name_the_typed_argument():
    stresses = dict(stress_v=1e5, stress_h=5e4)
    rest = {name: value for name, value in STATE.items() if name != "pressure"}
    for name in stresses:
        with pytest.raises(granum.InvalidArgument) as error:
            granum.uniform_strain(**rest, **{**stresses, name: -1.0})
        assert error.value.name == name
    errors = granum.uniform_strain(**{**STATE, "pressure": np.array([1e5, -1.0])}).errors
    assert list(errors) == [(1,)] and errors[(1,)].startswith("pressure = ")


@pytest.mark.parametrize("wrong", [Nothing(), None, 1.5, "\ud800"])
def test_what_is_no_specimen_is_refused_by_name(wrong):
    for call in (
        lambda: granum.compress(wrong, [1e5]),
        lambda: granum.probe(wrong, mode="vh"),
        lambda: granum.shear(wrong, path="TXC", mean_stress=1e5),
    ):
        with pytest.raises(TypeError, match="specimen"):
            call()


def test_fabric_is_one_of_its_measures():
    measures = granum.fabric_measures(F33=0.4)
    for name in ("P2_coefficient", "mean_cos_2gamma", "anisotropy"):
        assert granum.fabric_measures(**{name: getattr(measures, name)}).F33 == pytest.approx(0.4)
    for wrong in ({}, {"F33": 0.4, "anisotropy": 0.2}, {"a": 1}):
        with pytest.raises(TypeError):
            granum.fabric_measures(**wrong)


def test_whole_numbers_of_any_length_are_numbers_and_flags_are_not():
    assert granum.bulk_density(grain_density=10**30, void_ratio=0) == 1e30
    with pytest.raises(TypeError, match="void_ratio"):
        granum.bulk_density(grain_density=2650.0, void_ratio=True)


class Nullable:
    """A column of pandas whose numbers may be missing: as an array it holds objects."""

    def __init__(self, *values):
        self.values = values

    def __array__(self, dtype=None, copy=None):
        return np.array(self.values, dtype=object)

    def to_numpy(self, dtype=None, na_value=None):
        return np.array([na_value if value is None else value for value in self.values], dtype=dtype)


def test_numbers_missing_in_a_column_of_pandas_are_missing():
    speeds = Nullable(320.0, None, 425.0)
    call = dict(law=granum.sphere(shear_modulus=26e9, poisson_ratio=0.22, radius=5e-4), radius=5e-4, void_ratio=0.58)
    call.update(pressure=[1e5, 2e5, 4e5], relative_error=0.02, grain_density=2500)
    assert granum.infer(**call, V_s=speeds) == granum.infer(**call, V_s=[320, np.nan, 425])
    with pytest.raises(TypeError, match="V_s"):
        granum.infer(**call, V_s=Nullable("320", "x", "y"))
