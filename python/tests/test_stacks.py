# SPDX-License-Identifier: GPL-3.0-or-later
"""Elastic functions on stacks of matrices: every element as by a call of its own, refused ones by their index."""

import pickle

import granum
import numpy as np
import pytest

DENSITY = 1650.0
OF_A_STIFFNESS = {
    "engineering_moduli": {},
    "isotropic_averages": {},
    "isotropic_projection": {},
    "plane_waves": dict(bulk_density=DENSITY, direction=[0.3, 0, 1]),
    "saturated": dict(grain_bulk_modulus=370e9, fluid_bulk_modulus=2.2e9, void_ratio=0.6),
    "symmetry_distances": {},
    "thomsen_parameters": {},
    "transversely_isotropic_projection": dict(axis=[0, 1, 1]),
}


@pytest.fixture(scope="module")
def stack():
    """Full stiffnesses (2, 3, 6, 6), nearly isotropic."""
    random = np.random.default_rng(11).normal(size=(2, 3, 6, 6))
    return granum.isotropic(bulk_modulus=2e9, shear_modulus=1e9).stiffness + (random + random.swapaxes(-1, -2)) * 2e7


def numbers(result):
    """All numbers and arrays of a result, nested ones with dots."""
    out = {}
    for name, value in result.to_dict().items():
        if isinstance(value, dict) and name not in ("errors",):
            out.update({f"{name}.{inner}": of for inner, of in value.items() if isinstance(of, (float, np.ndarray))})
        elif isinstance(value, (float, np.ndarray)):
            out[name] = value
    assert out
    return out


@pytest.mark.parametrize("name", OF_A_STIFFNESS)
def test_every_matrix_is_answered_as_by_a_call_of_its_own(name, stack):
    function, more = getattr(granum, name), OF_A_STIFFNESS[name]
    together = numbers(function(stack, **more))
    for index in np.ndindex(2, 3):
        for key, value in numbers(function(stack[index], **more)).items():
            np.testing.assert_array_equal(together[key][index], value, err_msg=f"{key} at {index}")


@pytest.mark.parametrize("name", OF_A_STIFFNESS)
def test_a_refused_matrix_is_nan_with_a_message_and_raises_under_strict(name, stack):
    function, more = getattr(granum, name), OF_A_STIFFNESS[name]
    wrong = stack.copy()
    wrong[1, 2] = np.triu(wrong[1, 2])
    result = function(wrong, **more)
    assert list(result.errors) == [(1, 2)] and "stiffness" in result.errors[1, 2]
    assert result.shape == (2, 3)
    good = numbers(function(stack, **more))
    for key, value in numbers(result).items():
        assert np.isnan(value[1, 2]).all(), key
        np.testing.assert_array_equal(value[0], good[key][0])
    with pytest.raises(granum.InvalidArgument, match="stiffness"):
        function(wrong, **more, strict=True)


def test_other_arguments_are_broadcast_with_the_matrices(stack):
    density, direction = np.array([[1500.0], [1700.0]]), np.eye(3)
    waves = granum.plane_waves(stack, bulk_density=density, direction=direction)
    assert waves.speed.shape == (2, 3, 3) and waves.polarisation.shape == (2, 3, 3, 3)
    for i, j in np.ndindex(2, 3):
        one = granum.plane_waves(stack[i, j], bulk_density=density[i, 0], direction=direction[j])
        np.testing.assert_array_equal(waves.speed[i, j], one.speed)
    rotations = np.linalg.qr(np.random.default_rng(3).normal(size=(3, 3, 3)))[0]
    rotations *= np.linalg.det(rotations)[:, None, None]
    turned = granum.rotate(stack, rotation=rotations)
    np.testing.assert_array_equal(turned[1, 2], granum.rotate(stack[1, 2], rotation=rotations[2]))
    np.testing.assert_array_equal(granum.rotate(stack[0, 0], rotation=rotations)[1], granum.rotate(stack[0, 0], rotation=rotations[1]))
    wet = granum.saturated(stack[0, 0], grain_bulk_modulus=370e9, fluid_bulk_modulus=2.2e9, void_ratio=[0.5, 0.7])
    assert wet.C33.shape == (2,) and wet.C33[0] > wet.C33[1]
    with pytest.raises(granum.InvalidArgument):
        granum.plane_waves(stack, bulk_density=[1.0, 2.0], direction=[0, 0, 1])
    with pytest.raises(granum.InvalidArgument, match="rotation"):
        granum.rotate(stack, rotation=2 * rotations)


def test_solids_of_arrays():
    bulk, shear = np.array([[1e8], [2e8]]), np.array([1e8, -1.0, 3e8])
    solids = granum.isotropic(bulk_modulus=bulk, shear_modulus=shear)
    assert solids.shape == (2, 3) and list(solids.errors) == [(0, 1), (1, 1)]
    one = granum.isotropic(bulk_modulus=2e8, shear_modulus=3e8)
    for name in ("young_modulus", "poisson_ratio", "lame_lambda", "stiffness"):
        np.testing.assert_array_equal(getattr(solids, name)[1, 2], getattr(one, name))
        assert np.isnan(getattr(solids, name)[0, 1]).all()
    speeds = solids.wave_speeds(bulk_density=[[1500.0], [1700.0]])
    assert speeds["s"][1, 2] == one.wave_speeds(bulk_density=1700)["s"] and np.isnan(speeds["p"][1, 1])
    again = pickle.loads(pickle.dumps(solids))
    assert again == solids and again.errors == solids.errors
    np.testing.assert_array_equal(again.wave_speeds(bulk_density=1500.0)["p"], solids.wave_speeds(bulk_density=1500.0)["p"])
    with pytest.raises(granum.InvalidArgument, match="shear_modulus = -1"):
        granum.isotropic(bulk_modulus=1e8, shear_modulus=shear, strict=True)
    densities = granum.bulk_density(grain_density=2650.0, void_ratio=[0.6, 0.7], pore_density=[[0.0], [998.0]])
    assert densities.shape == (2, 2) and densities[1, 0] == (2650 + 0.6 * 998) / 1.6
    np.testing.assert_array_equal(
        granum.water_and_air_bulk_modulus([0, 1]), [granum.water_and_air_bulk_modulus(s) for s in (0, 1)]
    )


@pytest.mark.parametrize("name", [*OF_A_STIFFNESS, "rotate"])
@pytest.mark.parametrize("shape", [(6,), (5, 6, 5), (6, 6, 1), ()])
def test_another_shape_is_refused_by_name(name, shape):
    more = {**OF_A_STIFFNESS.get(name, dict(rotation=np.eye(3)))}
    with pytest.raises(granum.InvalidArgument, match="stiffness"):
        getattr(granum, name)(np.ones(shape), **more)


def test_every_function_of_a_stiffness_is_among_those():
    takes = {name for name in granum.__all__ if "stiffness : (..., 6, 6)" in (getattr(granum, name).__doc__ or "")}
    assert takes == {*OF_A_STIFFNESS, "rotate"}


def test_no_matrices_give_no_numbers():
    none = np.empty((0, 6, 6))
    assert granum.engineering_moduli(none).E_1.shape == (0,)
    assert granum.rotate(none, rotation=np.eye(3)).shape == (0, 6, 6)
    assert granum.plane_waves(none, bulk_density=1.0, direction=[0, 0, 1]).speed.shape == (0, 3)
    assert granum.isotropic_averages(none).hill.stiffness.shape == (0, 6, 6)


def test_stiffnesses_of_an_estimate_go_through_as_they_are():
    law = granum.sphere(shear_modulus=30e9, poisson_ratio=0.15, radius=5e-4)
    state = dict(law=law, radius=5e-4, void_ratio=0.6, coordination_number=5.7)
    estimate = granum.uniform_strain(**state, pressure=[1e5, 2e5], fabric_anisotropy=0.2)
    moduli = granum.engineering_moduli(estimate.stiffness)
    assert granum.engineering_moduli(estimate) == moduli
    np.testing.assert_allclose(moduli.C44, estimate.C44)
    np.testing.assert_allclose(moduli.E_3, estimate.E_v)
