# SPDX-License-Identifier: GPL-3.0-or-later
"""Classical models, the ground and measured sands against formulas written here once more, in numpy."""

import subprocess

import granum
import numpy as np
import pytest

QUARTZ = dict(shear_modulus=44e9, poisson_ratio=0.1)
PACKING = dict(**QUARTZ, porosity=0.36, coordination_number=9.0)


def test_walton_is_norris_and_johnson_without_hydrostatic_strain():
    strains = np.geomspace(1e-6, 1e-3, 4)
    walton = granum.walton_uniaxial(**PACKING, uniaxial_strain=strains)
    both = granum.norris_johnson(**PACKING, hydrostatic_strain=0, uniaxial_strain=strains)
    assert np.allclose(walton.stiffness, both.stiffness, rtol=1e-13)
    r = granum.mindlin_stiffness_ratio(QUARTZ["poisson_ratio"])
    assert np.allclose(walton.C11 / walton.C33, 12 * (1 + r) / (16 * (2 + r)), rtol=1e-13)
    stress = granum.walton_uniaxial_stress(**PACKING, uniaxial_strain=strains)
    nu = QUARTZ["poisson_ratio"]
    assert np.allclose(stress.stress_h / stress.stress_v, nu / (4 * (3 - 2 * nu)), rtol=1e-13)
    path = dict(hydrostatic_strain=1e-4, uniaxial_strain=1e-4)
    orders = ("hydrostatic_first", "uniaxial_first", "simultaneous")
    stresses = [granum.norris_johnson_stress(**PACKING, **path, path=name).stress_v for name in orders]
    assert len(set(stresses)) == 3  # tangential forces remember the order
    with pytest.raises(granum.InvalidArgument, match="path"):
        granum.norris_johnson_stress(**PACKING, **path, path="sideways")


def test_norris_and_johnson_are_hertz_and_mindlin_without_uniaxial_strain():
    strain = 1e-4
    found = granum.norris_johnson(**PACKING, hydrostatic_strain=strain, uniaxial_strain=0)
    pressure = granum.norris_johnson_stress(
        **PACKING, hydrostatic_strain=strain, uniaxial_strain=0, path="simultaneous"
    ).stress_v
    classical = granum.hertz_mindlin(**PACKING, pressure=pressure)
    assert found.G_vh == pytest.approx(classical.shear_modulus, rel=1e-12)
    assert found.bulk_modulus == pytest.approx(classical.bulk_modulus, rel=1e-12)


def test_effective_stress_in_the_ground():
    depth = np.array([1.0, 2.0, 10.0])
    ground = dict(unit_weight=16e3, saturated_unit_weight=20e3, water_table=2, water_unit_weight=1e4)
    found = granum.ground_stress(depth=depth, **ground, earth_pressure_at_rest=0.4, surcharge=5e3)
    assert found.total_v.tolist() == [21e3, 37e3, 197e3]
    assert found.pore_pressure.tolist() == [0, 0, 80e3]
    assert found.stress_v.tolist() == [21e3, 37e3, 117e3]
    assert np.allclose(found.stress_h, 0.4 * found.stress_v, rtol=1e-15)
    assert np.allclose(found.total_h, found.stress_h + found.pore_pressure, rtol=1e-15)
    dry = granum.ground_stress(depth=3, unit_weight=16e3, earth_pressure_at_rest=0.5)
    assert (dry.stress_v, dry.pore_pressure) == (48e3, 0)
    with pytest.raises(TypeError, match="saturated_unit_weight"):
        granum.ground_stress(depth=3, unit_weight=16e3, water_table=1, earth_pressure_at_rest=0.5)


def test_full_pores_are_those_of_gassmann():
    dry = granum.isotropic(bulk_modulus=2e8, shear_modulus=1.5e8)
    K_s, K_f, e = 37e9, 2.2e9, 0.6
    n = e / (1 + e)
    wet = granum.saturated(dry.stiffness, grain_bulk_modulus=K_s, fluid_bulk_modulus=K_f, void_ratio=e)
    alpha = 1 - 2e8 / K_s
    expected = 2e8 + alpha**2 / (n / K_f + (alpha - n) / K_s)
    assert wet.bulk_modulus == pytest.approx(expected, rel=1e-13)
    assert wet.G_vh == pytest.approx(1.5e8, rel=1e-14)
    S, K_w, K_a = 0.9, granum.water_and_air_bulk_modulus(1), granum.water_and_air_bulk_modulus(0)
    assert granum.water_and_air_bulk_modulus(S) == pytest.approx(1 / (S / K_w + (1 - S) / K_a), rel=1e-14)


def test_published_laws_are_those_of_their_papers():
    e, p = np.array([0.5, 0.7]), 200e3
    found = granum.sand_shear_modulus(law="hardin-richart-round", void_ratio=e, pressure=p)
    assert np.allclose(found.shear_modulus, 6908e3 * (2.17 - e) ** 2 / (1 + e) * np.sqrt(p / 1e3), rtol=2e-3)
    assert set(granum.measured_laws()) >= {"hardin-richart-round", "kokusho", "menq"}
    assert granum.sand_shear_modulus(law="kokusho", void_ratio=0.7, pressure=5e6).notes  # beyond its tests
    with pytest.raises(granum.InvalidArgument, match="void_ratio"):
        granum.sand_shear_modulus(law="kokusho", void_ratio=-1, pressure=p)


def test_sands_by_name_equal_their_properties():
    toyoura = granum.known_sands()["toyoura"]
    state = dict(law=granum.sphere(**QUARTZ, radius=1e-4), radius=1e-4, void_ratio=0.75, pressure=100e3)
    by_name = granum.packing_answer(**state, sand="toyoura")
    by_numbers = granum.packing_answer(
        **state,
        grain_shape="sand",
        uniformity=toyoura.uniformity,
        d50=toyoura.d50,
        least_void_ratio=toyoura.least_void_ratio,
        largest_void_ratio=toyoura.largest_void_ratio,
    )
    assert by_name.shear_modulus.value == pytest.approx(by_numbers.shear_modulus.value, rel=0.25)
    assert granum.minerals()[toyoura.mineral].key == "quartz"


def test_relative_density_is_what_a_sand_without_limits_follows():
    state = dict(law=granum.sphere(**QUARTZ, radius=1e-4), radius=1e-4, void_ratio=0.75, pressure=100e3)

    def G(**sand):
        return granum.packing_answer(**state, grain_shape="sand", **sand).shear_modulus.value

    ratios = [G(relative_density=D_r) / G(relative_density=0.3) for D_r in (0.5, 0.9)]
    assert ratios == pytest.approx([10 ** (0.241 * 0.2), 10 ** (0.241 * 0.6)], rel=1e-12)
    limits = dict(least_void_ratio=0.6, largest_void_ratio=0.98)
    assert G(**limits, relative_density=0.61) == G(**limits)
    with pytest.raises(granum.InvalidArgument, match="relative_density"):
        G(**limits, relative_density=0.9)  # that of e 0.75 is 0.605
    assert granum.packing_answer(**state, relative_density=0.5).shear_modulus.value == G(relative_density=0.5)
    with pytest.raises(granum.InvalidArgument, match="relative_density"):
        G(relative_density=60)


def test_a_fit_finds_the_constants_again():
    p = np.array([50e3, 100e3, 200e3, 400e3, 800e3])
    constants = dict(coefficient=600, exponent_i=0.25, exponent_j=0.2, atmospheric_pressure=100e3)
    state = dict(stress_i=p, stress_j=p * [1, 0.5, 1, 0.5, 1], void_ratio=[0.6, 0.62, 0.6, 0.58, 0.6])
    G = granum.hardin(**constants, **state)
    e = np.array(state["void_ratio"])
    by_hand = 600 * 1e5 * (2.17 - e) ** 2 / (1 + e) * (p / 1e5) ** 0.25 * (state["stress_j"] / 1e5) ** 0.2
    assert np.allclose(G, by_hand, rtol=1e-14)
    found = granum.fit(shear_modulus=G, **state, atmospheric_pressure=100e3)
    values = [found.coefficient.value, found.exponent_i.value, found.exponent_j.value]
    assert np.allclose(values, [600, 0.25, 0.2], rtol=1e-9)
    assert found.covariance.shape == (3, 3) and found.degrees_of_freedom == 2
    with pytest.raises(granum.InvalidArgument):  # one stress ratio does not tell m from n
        granum.fit(shear_modulus=p**0.4, stress_i=p, stress_j=p, void_ratio=0.6, atmospheric_pressure=1e5)
    alone = granum.fit(
        shear_modulus=1e6 * p**0.4,
        stress_i=p,
        stress_j=p,
        void_ratio=0.6,
        atmospheric_pressure=1e5,
        sum_only=True,
    )
    assert alone.exponent_sum.value == pytest.approx(0.4, abs=1e-9) and alone.exponent_i is None


MAKERS = {
    "sphere": dict(radius=5e-4),
    "cone": dict(slope=0.4),
    "flat_punch": dict(punch_radius=5e-6),
    "power_law": dict(alpha=1.5, profile_constant=180.0),
    "rough_sphere": dict(radius=5e-4, roughness=1e-7),
}


@pytest.mark.parametrize("name", MAKERS)
def test_a_bulk_modulus_replaces_poissons_ratio(name):
    make = getattr(granum, name)
    law = make(shear_modulus=30e9, poisson_ratio=0.2, **MAKERS[name])
    assert law.bulk_modulus == pytest.approx(40e9, rel=1e-14)
    same = make(shear_modulus=30e9, bulk_modulus=40e9, **MAKERS[name])
    assert same.force(1e-6) == pytest.approx(law.force(1e-6), rel=1e-12)
    with pytest.raises(TypeError, match="poisson_ratio or bulk_modulus"):
        make(shear_modulus=30e9, poisson_ratio=0.2, bulk_modulus=40e9, **MAKERS[name])
    with pytest.raises(TypeError, match="'bulk_modulus'"):
        make(shear_modulus=30e9, **MAKERS[name])
    with pytest.raises(granum.InvalidArgument, match="bulk_modulus = -1"):
        make(shear_modulus=30e9, bulk_modulus=-1, **MAKERS[name])


def test_bulk_moduli_of_models_broadcast():
    K, G = np.array([[30e9], [37e9]]), 44e9
    nu = (3 * K - 2 * G) / (2 * (3 * K + G))
    rest = dict(porosity=0.36, coordination_number=9, pressure=[1e6, 1e7, 2e7])
    found = granum.hertz_mindlin(shear_modulus=G, bulk_modulus=K, **rest)
    same = granum.hertz_mindlin(shear_modulus=G, poisson_ratio=nu, **rest)
    assert found.shear_modulus.shape == (2, 3)
    assert np.allclose(found.shear_modulus, same.shear_modulus, rtol=1e-13)
    cement = dict(porosity=0.36, coordination_number=9, cement_saturation=0.1, cement_shear_modulus=44e9)
    assert granum.cement_at_contacts(
        **QUARTZ, **cement, cement_bulk_modulus=37e9
    ).shear_modulus == pytest.approx(
        granum.cement_at_contacts(
            **QUARTZ, **cement, cement_poisson_ratio=(3 * 37 - 2 * 44) / (2 * (3 * 37 + 44))
        ).shear_modulus,
        rel=1e-13,
    )


def test_a_bulk_modulus_on_the_command_line_is_that_of_python(run_program):
    state = ("--void-ratio", 0.6, "--pressure", "100kPa", "--grain-shape", "sphere")
    said = run_program("estimate", *state, "--grain-shear-modulus", "44GPa", "--grain-bulk-modulus", "37GPa")
    law = granum.sphere(shear_modulus=44e9, bulk_modulus=37e9, radius=0.5e-3)
    assert said["inputs"]["grain_poisson_ratio"] == law.poisson_ratio
    answer = granum.packing_answer(law=law, radius=0.5e-3, void_ratio=0.6, pressure=100e3)
    assert said["answer"]["shear_modulus"]["value"] == answer.shear_modulus.value
    both = ("--grain-bulk-modulus", "37GPa", "--grain-poisson-ratio", 0.1)
    with pytest.raises(subprocess.CalledProcessError) as refused:
        run_program("estimate", *state, *both)
    assert refused.value.returncode == 2


def test_sources_of_laws_minerals_and_sands_are_typeset_references():
    sources = granum.references()
    cited = [row for table in (granum.known_sands(), granum.measured_laws(), granum.minerals()) for row in table.values()]
    for key in {key for row in cited for key in row.source.split("; ")}:
        said = sources[key].text + sources[key].remark
        assert not set("\\{}$") & set(said) and "from memory" not in said
    assert sources["OztoprakBolton2013"].text.endswith("database. Géotechnique 63(1), 54–70.")
    assert sources["Hertz1882"].link == "https://doi.org/10.1515/crll.1882.92.156"
