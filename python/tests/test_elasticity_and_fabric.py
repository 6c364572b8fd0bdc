# SPDX-License-Identifier: GPL-3.0-or-later
"""The elastic toolkit and fabric against plain numpy."""

import math

import granum
import numpy as np
import pytest

VOIGT = [(0, 0), (1, 1), (2, 2), (1, 2), (0, 2), (0, 1)]


def tensor(matrix):
    """C_ijkl of a Voigt matrix."""
    out = np.zeros((3, 3, 3, 3))
    for a, (i, j) in enumerate(VOIGT):
        for b, (k, l) in enumerate(VOIGT):
            for p, q in ((i, j), (j, i)):
                for r, s in ((k, l), (l, k)):
                    out[p, q, r, s] = matrix[a, b]
    return out


@pytest.fixture(scope="module")
def stiffness():
    """A full stiffness without any symmetry."""
    random = np.random.default_rng(5).normal(size=(6, 6))
    return (random @ random.T + 6 * np.eye(6)) * 1e8


def test_plane_waves_are_eigenvectors_of_the_christoffel_tensor(stiffness):
    directions = np.random.default_rng(1).normal(size=(4, 5, 3))
    waves = granum.plane_waves(stiffness, bulk_density=1650.0, direction=directions)
    assert waves.speed.shape == (4, 5, 3) and waves.polarisation.shape == (4, 5, 3, 3)
    for index in np.ndindex(4, 5):
        n = directions[index] / np.linalg.norm(directions[index])
        christoffel = np.einsum("ijkl,j,l->ik", tensor(stiffness), n, n)
        squares = np.linalg.eigvalsh(christoffel)[::-1] / 1650.0
        np.testing.assert_allclose(waves.speed[index] ** 2, squares, rtol=1e-12)
        for speed, motion in zip(waves.speed[index], waves.polarisation[index]):
            np.testing.assert_allclose(christoffel @ motion, 1650.0 * speed**2 * motion, atol=1e-12 * 1e9)
    with pytest.raises(granum.InvalidArgument, match=r"direction has the shape \(2,\)"):
        granum.plane_waves(stiffness, bulk_density=1650.0, direction=[1, 0])


def test_projections_are_means_over_rotations(stiffness):
    isotropic = granum.isotropic_projection(stiffness)
    assert isotropic.bulk_modulus == pytest.approx(stiffness[:3, :3].sum() / 9, rel=1e-14)
    turns = [
        2 * math.pi * k / 7 for k in range(7)
    ]  # a mean over seven angles is exact up to the sixth harmonic
    rotations = [
        np.array([[math.cos(t), -math.sin(t), 0], [math.sin(t), math.cos(t), 0], [0, 0, 1]]) for t in turns
    ]
    mean = np.mean([granum.rotate(stiffness, rotation=r) for r in rotations], axis=0)
    about_axis_3 = granum.transversely_isotropic_projection(stiffness)
    np.testing.assert_allclose(about_axis_3.stiffness, mean, atol=1e-12 * stiffness.max())
    assert granum.transversely_isotropic_projection(stiffness, axis=[0, 0, 2]).C33 == pytest.approx(
        about_axis_3.C33
    )
    distances = granum.symmetry_distances(about_axis_3.stiffness)
    assert distances.transversely_isotropic < 1e-14 < distances.isotropic


def test_rotations_turn_the_tensor(stiffness):
    rotation = np.linalg.qr(np.random.default_rng(2).normal(size=(3, 3)))[0]
    rotation *= np.linalg.det(rotation)
    turned = np.einsum("ai,bj,ck,dl,ijkl->abcd", *[rotation] * 4, tensor(stiffness))
    np.testing.assert_allclose(tensor(granum.rotate(stiffness, rotation=rotation)), turned, atol=1e-13 * 1e10)
    with pytest.raises(granum.InvalidArgument):
        granum.rotate(stiffness, rotation=2 * rotation)


def test_averages_bound_each_other(stiffness):
    averages = granum.isotropic_averages(stiffness)
    assert averages.reuss.shear_modulus < averages.hill.shear_modulus < averages.voigt.shear_modulus
    compliance = np.linalg.inv(stiffness)
    assert averages.reuss.bulk_modulus == pytest.approx(1 / compliance[:3, :3].sum(), rel=1e-12)
    moduli = granum.engineering_moduli(stiffness)
    assert moduli.E_2 == pytest.approx(1 / compliance[1, 1], rel=1e-12)


def test_isotropic_solids():
    solid = granum.isotropic(bulk_modulus=2e8, shear_modulus=1e8)
    assert solid.young_modulus == pytest.approx(9 * 2e8 * 1e8 / (3 * 2e8 + 1e8))
    density = granum.bulk_density(grain_density=2650, void_ratio=0.6)
    assert density == pytest.approx(2650 / 1.6)
    assert solid.wave_speeds(bulk_density=density)["s"] == pytest.approx(math.sqrt(1e8 / density))
    np.testing.assert_allclose(solid.stiffness[3:, 3:], np.diag([1e8] * 3))


def test_thomsen_parameters():
    law = granum.sphere(shear_modulus=30e9, poisson_ratio=0.15, radius=5e-4)
    c = granum.uniform_strain(
        law=law, radius=5e-4, void_ratio=0.6, coordination_number=5.7, stress_v=1e5, stress_h=5e4
    )
    found = granum.thomsen_parameters(c.stiffness)
    assert found.epsilon == pytest.approx((c.C11 - c.C33) / (2 * c.C33), rel=1e-12)
    assert found.gamma == pytest.approx((c.C66 - c.C44) / (2 * c.C44), rel=1e-12)
    weak = granum.thomsen_parameters(c.stiffness, weak=True)
    assert weak.delta == pytest.approx((c.C13 + 2 * c.C44 - c.C33) / c.C33, rel=1e-12)


@pytest.mark.parametrize("wrong", [np.eye(3), np.ones((6, 6, 1)), [1.0]])
def test_a_stiffness_of_another_shape_is_refused_by_name(wrong):
    with pytest.raises(granum.InvalidArgument, match="stiffness has the shape"):
        granum.isotropic_projection(wrong)


def test_the_density_of_directions_is_one():
    cosines, weights = np.polynomial.legendre.leggauss(20)
    for anisotropy in (-1, -0.3, 0, 0.8):
        density = granum.fabric_density(polar_angle=np.arccos(cosines), anisotropy=anisotropy)
        assert 2 * math.pi * weights @ density == pytest.approx(1, rel=1e-14)
        mean_square = 2 * math.pi * weights @ (density * cosines**2)
        assert granum.fabric_measures(anisotropy=anisotropy).F33 == pytest.approx(mean_square, rel=1e-14)
    shares = granum.fabric_cumulative_probability(polar_cosine=[0.2, 0.7], anisotropy=0.5)
    back = granum.fabric_polar_cosine_quantile(probability=shares, anisotropy=0.5)
    np.testing.assert_allclose(back, [0.2, 0.7], rtol=1e-14)


def test_fabric_measures_by_any_of_them():
    measures = granum.fabric_measures(F33=0.4)
    assert granum.fabric_measures(P2_coefficient=measures.P2_coefficient).anisotropy == pytest.approx(
        measures.anisotropy
    )
    assert granum.fabric_measures(mean_cos_2gamma=measures.mean_cos_2gamma).F33 == pytest.approx(0.4)
    for wrong in ({}, {"F33": 0.4, "anisotropy": 0.2}):
        with pytest.raises(TypeError, match="takes one of"):
            granum.fabric_measures(**wrong)
    with pytest.raises(TypeError, match="unexpected keyword argument 'a'"):
        granum.fabric_measures(a=1)


def test_samples_of_directions_give_their_anisotropy_back():
    normals = granum.sample_normals(anisotropy=0.5, count=20000, seed=3)
    assert normals.shape == (20000, 3)
    np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1, rtol=1e-14)
    for estimate in (granum.estimate_anisotropy(normals), granum.estimate_anisotropy_by_likelihood(normals)):
        assert abs(estimate.anisotropy - 0.5) < 4 * estimate.standard_error < 0.05
    assert granum.isotropy_p_value(normals) < 1e-6
    bins = granum.rose(normals, anisotropy=0.5, bins=9)
    assert sum(bin.count for bin in bins) == 20000
    assert (normals == granum.sample_normals(anisotropy=0.5, count=20000, seed=3)).all()
    with pytest.raises(granum.InvalidArgument, match=r"normals has the shape \(3,\)"):
        granum.estimate_anisotropy([0, 0, 1])


def test_sizes():
    sizes = granum.Distribution("lognormal:0.35")
    assert sizes.moment(1) == pytest.approx(1, rel=1e-12)
    assert sizes.quantile(sizes.share_below(1.1, k=3), k=3) == pytest.approx(1.1, rel=1e-10)
    radii = sizes.sample(count=5000, seed=1)
    assert radii.mean() == pytest.approx(1, rel=1e-3)
    drawn, exact = granum.gradation(radii), sizes.gradation(mean_radius=1.0)
    assert drawn.uniformity == pytest.approx(exact.uniformity, rel=0.02)
    means = granum.expected_contact_means(sizes, rattler_fraction=0.1)
    assert means.branch_square > means.branch**2
    assert granum.ContactMeans() == granum.expected_contact_means(granum.Distribution("equal"))
    with pytest.raises(granum.InvalidArgument):
        granum.ContactMeans(branch=-1)
    law = granum.sphere(shear_modulus=30e9, poisson_ratio=0.15, radius=5e-4 * means.pair_radius)
    unequal = granum.uniform_strain(
        law=law, radius=5e-4, void_ratio=0.6, coordination_number=5.0, pressure=1e5, contact_means=means
    )
    assert unequal.G_vh > 0


OF_A_STIFFNESS = {
    "engineering_moduli": {},
    "isotropic_averages": {},
    "isotropic_projection": {},
    "plane_waves": dict(bulk_density=1650.0, direction=[0, 0, 1]),
    "rotate": dict(rotation=np.eye(3)),
    "saturated": dict(grain_bulk_modulus=37e9, fluid_bulk_modulus=2.2e9, void_ratio=0.6),
    "symmetry_distances": {},
    "thomsen_parameters": {},
    "transversely_isotropic_projection": {},
}


@pytest.mark.parametrize("name", OF_A_STIFFNESS)
def test_half_of_a_stiffness_is_refused(name, stiffness):
    function, more = getattr(granum, name), OF_A_STIFFNESS[name]
    function(stiffness, **more)
    for half in (np.triu(stiffness), np.tril(stiffness)):
        with pytest.raises(granum.InvalidArgument, match="stiffness"):
            function(half, **more)


def test_every_function_of_a_stiffness_is_among_those():
    takes = {name for name in granum.__all__ if "stiffness : (..., 6, 6)" in (getattr(granum, name).__doc__ or "")}
    assert takes == OF_A_STIFFNESS.keys()
