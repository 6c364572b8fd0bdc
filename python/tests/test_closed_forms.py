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
    with pytest.raises(granum.InvalidArgument, match="void_ratio|coordination_number"):
        granum.uniform_strain(**{**STATE, "void_ratio": [0.5, 0.6], "coordination_number": [4, 5, 6]})


def test_a_bad_element_is_nan_with_its_message_or_raises():
    wrong = {**STATE, "void_ratio": np.array([[0.6, -1.0], [np.nan, 0.7]])}
    result = granum.uniform_strain(**wrong)
    assert list(result.errors) == [(0, 1), (1, 0)] and all("void_ratio" in said for said in result.errors.values())
    assert np.isnan(result.G_vh).tolist() == [[False, True], [True, False]]
    with pytest.raises(granum.InvalidArgument) as refused:
        granum.uniform_strain(**wrong, strict=True)
    assert isinstance(refused.value, ValueError)
    assert (refused.value.name, refused.value.value, refused.value.range) == ("void_ratio", -1.0, "(0, inf)")


def test_wrong_missing_and_doubled_keywords_are_named():
    unloaded = {name: value for name, value in STATE.items() if name != "pressure"}
    for keywords, named in [
        ({**STATE, "porosity": 0.4}, "porosity"),
        ({**unloaded, "stress_v": 1e5}, "stress_h"),
        ({**STATE, "stress_v": 1e5}, "stress_v"),
    ]:
        with pytest.raises(TypeError, match=named):
            granum.uniform_strain(**keywords)
    with pytest.raises(TypeError, match="V_s"):  # which was meant
        granum.infer(law=LAW, Vs=280)
    with pytest.raises(TypeError):
        granum.uniform_strain(LAW)
    with pytest.raises(TypeError):
        granum.relaxed(**STATE, mechanical_coordination_number=5.8, rattler_fraction=0.02)


def test_rungs_by_number_and_by_name():
    known = {**STATE, "rattler_fraction": 0.02, "fabric_anisotropy": 0.2}
    for number, name in enumerate(("isotropic", "fabric", "directional", "relaxed")):
        assert len({granum.answer(rung=which, **known).C33 for which in (number, name, f"rung{number}")}) == 1
    for rung in (7, 3):  # there is none, and z* is missing
        with pytest.raises(granum.InvalidArgument):
            granum.answer(rung=rung, **STATE)


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


class TestBatch:
    """uniform_strain_moduli, which hands whole columns to the library's batch."""

    known = {"law": LAW, "radius": 0.5e-3, "porosity": 0.375, "coordination_number": 5.7, "pressure": 100e3}

    @pytest.mark.parametrize("count", [3, 2500])
    def test_bad_rows_are_nan_however_many(self, count):
        porosity = np.full(4000, 0.4)
        porosity[100 : 100 + count] = 40
        many = granum.uniform_strain_moduli(**{**self.known, "porosity": porosity})
        assert np.isnan(many.bulk_modulus).sum() == np.isnan(many.shear_modulus).sum() == len(many.errors) == count
        assert "porosity = 40" in many.errors[(100 + count - 1,)]
        with pytest.raises(granum.InvalidArgument, match="porosity"):
            granum.uniform_strain_moduli(**{**self.known, "porosity": porosity}, strict=True)

    def test_out_that_cannot_hold_the_results_is_refused(self):
        closed, whole, good = np.empty(6), np.empty(12), np.empty(6)
        closed.flags.writeable = False
        of_another_kind = [[0.0] * 6, np.empty(6, dtype=np.float32), np.ma.masked_array(np.empty(6)), closed, whole[::2]]
        for out in [good, (good,), *((good, other) for other in of_another_kind)]:
            with pytest.raises(TypeError):
                granum.uniform_strain_moduli(**{**self.known, "pressure": np.full(6, 1e5)}, out=out)
        for out in [(good, np.empty(7)), (good, good), (whole[:6], whole[5:11])]:
            with pytest.raises(granum.InvalidArgument):
                granum.uniform_strain_moduli(**{**self.known, "pressure": np.full(6, 1e5)}, out=out)

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
