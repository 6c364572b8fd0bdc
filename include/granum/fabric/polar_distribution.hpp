// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// How contact normals of density E(gamma; a) are distributed over t = |n3|, the cosine of the acute angle
/// between normal and axis: P(t) = t (3(1-a) + 2 a t^2)/(3-a).
/// Checked by tests/fabric/test_polar_distribution.cpp
namespace granum::fabric {

/// P(t), the share of contacts with |n3| <= t [1].
/// \param    polar_cosine   t in [0, 1]
/// \param    anisotropy     a in [-1, 1]
/// \throws   InvalidArgument outside these ranges
/// Accuracy  4 ulp.
[[nodiscard]] double cumulative_probability(double polar_cosine, double anisotropy);

/// The t with P(t) = probability: the inverse of the above, from sums, products and quotients alone, so that
/// every machine finds the same bits.
/// \param    probability   in [0, 1]
/// \param    anisotropy    a in [-1, 1]; at a = 1, t is the cube root of the probability
/// \throws   InvalidArgument outside these ranges
/// Accuracy  P of the result is the probability to 1e-15 relative.
[[nodiscard]] double polar_cosine_quantile(double probability, double anisotropy);

} // namespace granum::fabric
