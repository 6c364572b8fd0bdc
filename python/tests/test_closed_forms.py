# SPDX-License-Identifier: GPL-3.0-or-later
"""Closed forms on arrays: each element is what a call with its numbers says."""

import math

import granum
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

LAW = granum.sphere(shear_modulus=30e9, poisson_ratio=0.15, radius=0.5e-3)
STATE = {"law": LAW, "radius": 0.5e-3, "void_ratio": 0.6, "coordination_number": 5.7, "pressure": 100e3}

RANGES = {
    "void_ratio": (0.3, 1.2),
    "coordination_number": (2.0, 11.0),
    "fabric_anisotropy": (-0.9, 0.9),
    "stress_v": (1e3, 1e6),
    "stress_h": (1e3, 1e6),
    "tangential_ratio": (0.0, 1.0),
    "rolling": (0.0, 1.0),
    "unevenness": (-0.5, 0.5),
}
FORMS = [
    granum.uniform_strain,
    granum.free_spin,
    granum.uniform_stress,
    lambda **state: granum.relaxed(rattler_fraction=0.05, **state),
    lambda **state: granum.answer(rung=1, **state),
]
MEMBERS = [
    "C11",
    "C33",
    "C12",
    "C13",
    "C44",
    "C66",
    "G_hh",
    "G_vh",
    "bulk_modulus",
    "E_v",
    "E_h",
    "nu_vh",
    "nu_hv",
    "nu_hh",
]


@st.composite
def broadcast_states(draw):
    """Arrays of shapes that go together, some of them single numbers, some lists of float32."""
    shapes = draw(
        hnp.mutually_broadcastable_shapes(num_shapes=len(RANGES), max_dims=3, max_side=3)
    ).input_shapes
    state = {}
    for (name, (low, high)), shape in zip(RANGES.items(), shapes):
        dtype = draw(st.sampled_from([np.float64, np.float32]))
        width = 8 * np.dtype(dtype).itemsize
        low, high = (float(np.float32(x)) for x in (low, high))
        elements = st.floats(low, high, width=width)
        array = draw(hnp.arrays(dtype, shape, elements=elements))
        if draw(st.booleans()):
            array = np.repeat(array, 2, axis=-1)[..., ::2] if array.ndim else array  # not contiguous
        if draw(st.booleans()):
            array = np.asfortranarray(array)
        state[name] = array
    return state


@given(state=broadcast_states(), form=st.sampled_from(FORMS))
def test_every_element_is_the_call_with_its_numbers(state, form):
    result = form(law=LAW, radius=0.5e-3, **state)
    arrays = np.broadcast_arrays(*state.values())
    assert np.shape(result.C11) == arrays[0].shape
    for index in np.ndindex(arrays[0].shape):
        one = {name: float(array[index]) for name, array in zip(state, arrays)}
        if index in result.errors:
            with pytest.raises(granum.InvalidArgument) as refused:
                form(law=LAW, radius=0.5e-3, **one)
            assert str(refused.value) == result.errors[index]
            assert all(math.isnan(getattr(result, name)[index]) for name in MEMBERS)
            continue
        alone = form(law=LAW, radius=0.5e-3, **one)
        for name in MEMBERS:
            np.testing.assert_equal(np.asarray(getattr(result, name))[index], getattr(alone, name))
        np.testing.assert_equal(result.stiffness[index], alone.stiffness)


def test_numbers_give_floats_and_arrays_give_arrays():
    assert type(granum.uniform_strain(**STATE).G_vh) is float
    assert granum.uniform_strain(**STATE).stiffness.shape == (6, 6)
    zero_dimensional = granum.uniform_strain(**{**STATE, "void_ratio": np.array(0.6)})
    assert type(zero_dimensional.G_vh) is float
    row = granum.uniform_strain(**{**STATE, "void_ratio": [0.5, 0.6]})
    assert row.shape == (2,) and row.stiffness.shape == (2, 6, 6)
    empty = granum.uniform_strain(**{**STATE, "void_ratio": np.zeros((0, 3))})
    assert empty.G_vh.shape == (0, 3) and empty.stiffness.shape == (0, 3, 6, 6) and empty.errors == {}


def test_numbers_of_other_types():
    expected = granum.uniform_strain(**{**STATE, "pressure": 100000.0, "coordination_number": 6.0}).C11
    for six in (6, np.int8(6), np.uint64(6), np.float32(6), np.longdouble(6)):
        assert (
            granum.uniform_strain(**{**STATE, "pressure": 100_000, "coordination_number": six}).C11
            == expected
        )


@pytest.mark.parametrize(
    "wrong",
    [
        "0.6",
        None,
        True,
        0.6j,
        np.array(["0.6"]),
        np.array([True]),
        np.array([0.6, None]),
        np.ma.masked_array([0.6, 0.7], mask=[False, True]),
        [[0.6], [0.6, 0.7]],
        {"e": 0.6},
    ],
)
def test_objects_that_are_no_numbers_are_refused_by_name(wrong):
    with pytest.raises(TypeError, match="void_ratio"):
        granum.uniform_strain(**{**STATE, "void_ratio": wrong})


def test_shapes_that_do_not_go_together_are_named():
    with pytest.raises(
        granum.InvalidArgument,
        match=r"void_ratio of shape \(2,\).*coordination_number of shape \(3,\)|"
        r"coordination_number of shape \(3,\).*void_ratio of shape \(2,\)",
    ):
        granum.uniform_strain(**{**STATE, "void_ratio": [0.5, 0.6], "coordination_number": [4, 5, 6]})


def test_a_bad_element_is_nan_with_its_message_or_raises():
    void_ratios = np.array([[0.6, -1.0], [np.nan, 0.7]])
    result = granum.uniform_strain(**{**STATE, "void_ratio": void_ratios})
    assert result.errors == {
        (0, 1): "void_ratio = -1 is outside (0, inf)",
        (1, 0): "void_ratio = nan is outside (0, inf)",
    }
    assert np.isnan(result.G_vh).tolist() == [[False, True], [True, False]]
    with pytest.raises(granum.InvalidArgument) as refused:
        granum.uniform_strain(**{**STATE, "void_ratio": void_ratios}, strict=True)
    assert isinstance(refused.value, ValueError)
    assert (refused.value.name, refused.value.value, refused.value.range) == ("void_ratio", -1.0, "(0, inf)")
    assert granum.uniform_strain(**{**STATE, "void_ratio": [0.6, 0.7]}, strict=True).errors == {}


def test_a_wrong_keyword_is_named():
    with pytest.raises(TypeError, match="unexpected keyword argument 'porosity'$"):
        granum.uniform_strain(**STATE, porosity=0.4)
    with pytest.raises(TypeError, match="'Vs'; did you mean V_s"):
        granum.infer(law=LAW, Vs=280)
    with pytest.raises(TypeError, match="needs the keyword argument 'radius'"):
        granum.uniform_strain(**{name: value for name, value in STATE.items() if name != "radius"})
    with pytest.raises(TypeError, match="keyword arguments only"):
        granum.uniform_strain(LAW)
    with pytest.raises(TypeError, match="stress_h is missing"):
        granum.uniform_strain(law=LAW, radius=5e-4, void_ratio=0.6, coordination_number=5.7, stress_v=1e5)
    with pytest.raises(TypeError, match="leave out stress_v"):
        granum.uniform_strain(**STATE, stress_v=1e5)
    with pytest.raises(TypeError, match="give one"):
        granum.relaxed(**STATE, mechanical_coordination_number=5.8, rattler_fraction=0.02)


def test_rungs_by_number_and_by_name():
    known = {**STATE, "rattler_fraction": 0.02, "fabric_anisotropy": 0.2}
    for number, name, column in [
        (0, "isotropic", "rung0"),
        (1, "fabric", "rung1"),
        (2, "directional", "rung2"),
        (3, "relaxed", "rung3"),
    ]:
        values = {granum.answer(rung=which, **known).C33 for which in (number, name, column)}
        assert len(values) == 1
    assert granum.answer(rung=2, **known).C33 == granum.uniform_strain(**known).C33
    assert granum.answer(rung="uniform_stress", **known).C33 == granum.uniform_stress(**known).C33
    assert [rung.number for rung in granum.rungs()] == [0, 1, 2, 3, None, 4, 5]
    with pytest.raises(granum.InvalidArgument, match="not 7"):
        granum.answer(rung=7, **STATE)
    with pytest.raises(granum.InvalidArgument, match="z\\*"):
        granum.answer(rung=3, **STATE)


def test_shares_of_rattlers_are_z():
    by_share = granum.relaxed(**STATE, rattler_fraction=0.05)
    assert by_share.C11 == granum.relaxed(**STATE, mechanical_coordination_number=5.7 / (1 - 0.05)).C11
    assert by_share.relative_error.G_vh > 0
    assert granum.uniform_strain(**STATE).relative_error is None


def test_rolling_resistance_is_of_rung_3_alone_and_within_its_fit():
    dense = {**STATE, "mechanical_coordination_number": 5.8}
    free, rolls = granum.relaxed(**dense), granum.relaxed(**dense, rolling=[0, 0.1, 1])
    assert rolls.G_vh[0] == free.G_vh and rolls.bulk_modulus[0] == free.bulk_modulus
    assert np.all(np.diff(rolls.G_vh) > 0) and np.all(rolls.G_vh < granum.uniform_strain(**STATE).G_vh)
    assert granum.uniform_strain(**STATE, rolling=1).G_vh == granum.uniform_strain(**STATE).G_vh
    for outside in (-0.1, 1.1, math.nan):
        with pytest.raises(granum.InvalidArgument, match="rolling"):
            granum.relaxed(**dense, rolling=outside)


def test_known_forces_are_of_rung_3_alone():
    # The gain by forces that are even (Q = 0) instead of those of the fit, and its smaller error.
    dense = {**STATE, "mechanical_coordination_number": 5.8}
    usual, known = granum.relaxed(**dense), granum.relaxed(**dense, unevenness=[-0.06, -0.03, 0])
    assert np.all(np.diff(known.G_vh) > 0) and np.all(np.diff(known.bulk_modulus) > 0)
    assert np.all(known.relative_error.G_vh < usual.relative_error.G_vh)
    assert known.G_vh[1] == pytest.approx(usual.G_vh, rel=0.05)
    assert granum.uniform_strain(**STATE, unevenness=0.1).G_vh == granum.uniform_strain(**STATE).G_vh
    for outside in (-1.1, 1.1, math.nan):
        with pytest.raises(granum.InvalidArgument, match="unevenness"):
            granum.relaxed(**dense, unevenness=outside)


def test_known_forces_are_those_of_a_measured_packing():
    start = granum.specimen(law=LAW, radius=0.5e-3, friction_coefficient=0.5, kind="dense", grains=60)
    measured = granum.measure(next(iter(granum.compress(start, [50e3]))).packing, law=LAW)
    network = measured.microstructure
    by_hand = granum.relaxed(
        law=LAW,
        radius=0.5e-3,
        void_ratio=measured.void_ratio,
        coordination_number=network.coordination_number,
        mechanical_coordination_number=network.mechanical_coordination_number,
        fabric_anisotropy=network.fabric_anisotropy,
        pressure=measured.stress.mean,
        unevenness=measured.forces.unevenness,
    )
    assert by_hand.G_vh == pytest.approx(measured.rungs["rung3"].G_vh, rel=1e-5)


def test_notes_come_once():
    many = granum.uniform_strain(**{**STATE, "coordination_number": np.full(100, 0.0)})
    assert len(many.notes) == 1


def test_results_are_views_that_outlive_their_object():
    values = granum.uniform_strain(**{**STATE, "void_ratio": np.linspace(0.4, 0.8, 1000)}).C11
    assert not values.flags.owndata and not values.flags.writeable
    assert values[0] == granum.uniform_strain(**{**STATE, "void_ratio": 0.4}).C11


def test_methods_of_laws_take_arrays():
    overlaps = np.array([[1e-7, 2e-7], [3e-7, 4e-7]])
    forces = LAW.force(overlaps)
    assert forces.shape == (2, 2) and forces[1, 0] == LAW.force(3e-7)
    np.testing.assert_allclose(LAW.overlap(forces), overlaps, rtol=1e-14)
    np.testing.assert_allclose(LAW.stiffness_at_overlap(overlaps), 1.5 * forces / overlaps, rtol=1e-14)
    with pytest.raises(granum.InvalidArgument, match="overlap"):
        LAW.force([1e-7, -1e-7])


MATERIAL = {"shear_modulus": 30e9, "poisson_ratio": 0.15}


@pytest.mark.parametrize(
    "shape, maker, numbers",
    [
        ("sphere", granum.sphere, {"radius": 0.5e-3}),
        ("cone", granum.cone, {"slope": 0.4}),
        ("flat", granum.flat_punch, {"punch_radius": 5.7e-6}),
        ("power-law", granum.power_law, {"alpha": 1.5, "profile_constant": 180}),
        ("power-law", granum.power_law, {"alpha": 0.5, "profile_constant": 0.01}),
        ("rough", granum.rough_sphere, {"radius": 0.5e-3, "roughness": 0}),
    ],
)
def test_laws_by_name_are_those_of_their_makers(shape, maker, numbers):
    law, made = granum.contact_law(shape, **MATERIAL, **numbers), maker(**MATERIAL, **numbers)
    assert repr(law) == repr(made)
    assert law.force(1e-7) == made.force(1e-7)
    assert law.exponent_at_force(0.1) == law.stiffness_exponent
    missing = dict(numbers)
    left_out, _ = missing.popitem()
    with pytest.raises(TypeError, match=left_out):
        granum.contact_law(shape, **MATERIAL, **missing)
    with pytest.raises(TypeError, match="colour"):
        granum.contact_law(shape, **MATERIAL, **numbers, colour=1)


def test_rough_spheres_stiffen_as_their_force_under_little_of_it_and_as_spheres_under_much():
    numbers = {**MATERIAL, "radius": 0.5e-3}
    rough, smooth = granum.rough_sphere(**numbers, roughness=20e-9), granum.sphere(**numbers)
    force = np.logspace(-7, 6, 40)
    exponent, ratio = rough.exponent_at_force(force), rough.stiffness_at_force(force) / smooth.stiffness_at_force(force)
    assert exponent[0] == pytest.approx(1, abs=1e-3)
    assert exponent[-1] == pytest.approx(1 / 3, abs=1e-5)
    assert (np.diff(exponent) < 0).all() and (np.diff(ratio) > 0).all()
    assert rough.force(rough.overlap(0.1)) == pytest.approx(0.1, rel=1e-12)
    with pytest.raises(granum.InvalidArgument, match="RoughSphere"):
        rough.alpha
    with pytest.raises(granum.InvalidArgument, match="roughness"):
        granum.rough_sphere(**numbers, roughness=-1e-9)


def test_a_law_that_is_none_is_refused_with_those_there_are():
    with pytest.raises(granum.InvalidArgument, match="cube.*sphere"):
        granum.contact_law("cube", **MATERIAL)


class TestBatch:
    """uniform_strain_moduli, which hands whole columns to the library's batch."""

    known = {"law": LAW, "radius": 0.5e-3, "porosity": 0.375, "coordination_number": 5.7, "pressure": 100e3}

    def test_is_rung_0(self):
        porosity = np.linspace(0.3, 0.5, 700)[:, None]
        pressure = np.logspace(3, 6, 5)
        many = granum.uniform_strain_moduli(**{**self.known, "porosity": porosity, "pressure": pressure})
        alone = granum.answer(
            rung=0,
            law=LAW,
            radius=0.5e-3,
            coordination_number=5.7,
            pressure=pressure,
            void_ratio=porosity / (1 - porosity),
        )
        assert many.bulk_modulus.shape == (700, 5)
        np.testing.assert_allclose(many.bulk_modulus, alone.bulk_modulus, rtol=1e-14)
        np.testing.assert_allclose(many.shear_modulus, alone.G_vh, rtol=1e-14)

    @pytest.mark.parametrize("count", [3, 2500])
    def test_bad_rows_are_nan_however_many(self, count):
        porosity = np.full(4000, 0.4)
        porosity[100 : 100 + count] = 40
        many = granum.uniform_strain_moduli(**{**self.known, "porosity": porosity})
        assert (
            np.isnan(many.bulk_modulus).sum()
            == np.isnan(many.shear_modulus).sum()
            == len(many.errors)
            == count
        )
        assert many.errors[(100 + count - 1,)] == "porosity = 40 is outside (0, 1)"
        with pytest.raises(granum.InvalidArgument, match="porosity = 40"):
            granum.uniform_strain_moduli(**{**self.known, "porosity": porosity}, strict=True)

    def test_results_go_where_out_says(self):
        columns = {"porosity": np.linspace(0.3, 0.5, 40)[:, None], "pressure": np.logspace(3, 6, 5)}
        fresh = granum.uniform_strain_moduli(**{**self.known, **columns})
        bulk, shear = np.full((40, 5), -1.0), np.full((40, 5), -1.0)
        moduli = granum.uniform_strain_moduli(**{**self.known, **columns}, out=(bulk, shear))
        assert moduli.bulk_modulus is bulk and moduli.shear_modulus is shear
        np.testing.assert_array_equal(bulk, fresh.bulk_modulus)
        np.testing.assert_array_equal(shear, fresh.shear_modulus)

    @pytest.mark.parametrize("bad", [0, 1500])
    def test_out_may_be_the_memory_of_the_arguments(self, bad):
        porosity, pressure = np.linspace(0.3, 0.5, 4000), np.logspace(3, 6, 4000)
        porosity[:bad] = 40
        fresh = granum.uniform_strain_moduli(**{**self.known, "porosity": porosity, "pressure": pressure})
        shifted = np.empty(4001)
        shifted[:-1] = pressure
        moduli = granum.uniform_strain_moduli(
            **{**self.known, "porosity": porosity, "pressure": shifted[:-1]}, out=[porosity, shifted[1:]]
        )
        np.testing.assert_array_equal(porosity, fresh.bulk_modulus)
        np.testing.assert_array_equal(shifted[1:], fresh.shear_modulus)
        assert moduli.errors == fresh.errors and len(moduli.errors) == bad

    def test_out_that_cannot_hold_the_results_is_refused(self):
        known = {**self.known, "pressure": np.full(6, 1e5)}
        closed, whole = np.empty(6), np.empty(12)
        closed.flags.writeable = False
        good = np.empty(6)
        for out, error, message in [
            (good, TypeError, "two arrays"),
            ((good,), TypeError, "two arrays"),
            ((good, [0.0] * 6), TypeError, "two arrays"),
            ((good, np.empty(6, dtype=np.float32)), TypeError, "float64"),
            ((good, np.ma.masked_array(np.empty(6))), TypeError, "two arrays"),
            ((good, closed), TypeError, "cannot be written"),
            ((good, whole[::2]), TypeError, "rows do not follow"),
            ((good, np.empty(7)), granum.InvalidArgument, r"out has the shape \(7,\), the results have \(6,\)"),
            ((good, good), granum.InvalidArgument, "same memory"),
            ((whole[:6], whole[5:11]), granum.InvalidArgument, "same memory"),
        ]:
            with pytest.raises(error, match=message):
                granum.uniform_strain_moduli(**known, out=out)

    def test_numbers_raise(self):
        assert type(granum.uniform_strain_moduli(**self.known).shear_modulus) is float
        with pytest.raises(granum.InvalidArgument, match="porosity = 40"):
            granum.uniform_strain_moduli(**{**self.known, "porosity": 40})


def test_classical_models():
    packing = {"shear_modulus": 45e9, "poisson_ratio": 0.08, "coordination_number": 9.0, "pressure": 10e6}
    rough = granum.hertz_mindlin(porosity=0.36, **packing)
    # the formula of Hertz and Mindlin as it is printed in The Rock Physics Handbook, by hand
    c, phi, g, nu, p = 9.0, 0.36, 45e9, 0.08, 10e6
    bulk = (c**2 * (1 - phi) ** 2 * g**2 * p / (18 * math.pi**2 * (1 - nu) ** 2)) ** (1 / 3)
    shear = (
        (5 - 4 * nu)
        / (5 * (2 - nu))
        * (3 * c**2 * (1 - phi) ** 2 * g**2 * p / (2 * math.pi**2 * (1 - nu) ** 2)) ** (1 / 3)
    )
    assert rough.bulk_modulus == pytest.approx(bulk, rel=1e-14)
    assert rough.shear_modulus == pytest.approx(shear, rel=1e-14)
    smooth = granum.hertz_mindlin(porosity=0.36, no_slip_fraction=0, **packing)
    assert smooth.shear_modulus == pytest.approx(0.6 * bulk, rel=1e-14)
    assert granum.digby(porosity=0.36, bond_radius_ratio=0, **packing).bulk_modulus == pytest.approx(
        bulk, rel=1e-14
    )
    porosity = np.array([0.0, 0.1, 0.36])
    soft = granum.soft_sand(critical_porosity=0.36, porosity=porosity, **packing)
    stiff = granum.stiff_sand(critical_porosity=0.36, porosity=porosity, **packing)
    assert soft.bulk_modulus[2] == stiff.bulk_modulus[2] == rough.bulk_modulus
    assert soft.shear_modulus[0] == stiff.shear_modulus[0] == 45e9
    assert soft.shear_modulus[1] < stiff.shear_modulus[1]
    assert granum.murphy_coordination_number(porosity=0.2, relation="table") == 14.007
