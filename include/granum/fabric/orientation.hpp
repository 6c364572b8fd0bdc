// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/core/error.hpp>

/// Directions of contact normals, axisymmetric about axis 3: E(gamma) = 3 (1 + a cos 2 gamma)/(4 pi (3 - a)).
/// a > 0: more contacts near the axis; a = 0: isotropic. E is a density, never negative, for -1 <= a <= 1.
namespace granum::fabric {

/// Means of n_i n_j; F22 = F11, the others are zero, 2 F11 + F33 = 1.
struct SecondMoments {
  double F11 = 1.0 / 3;
  double F33 = 1.0 / 3;
};

/// Means of n_i n_j n_k n_l; the names carry the indices, n2222 = n1111 and n2233 = n1133.
struct FourthMoments {
  double n1111 = 1.0 / 5;
  double n3333 = 1.0 / 5;
  double n1122 = 1.0 / 15;
  double n1133 = 1.0 / 15;
};

/// Density of contact normals per solid angle, E(gamma; a) [1/sr].                        [Chung2014, Eq. 10]
/// \param    polar_angle   gamma, from axis 3 [rad]
/// \param    anisotropy    a in [-1, 1]
/// \throws   InvalidArgument if the angle is not finite or |a| > 1, where E is no density
/// Accuracy  2 ulp of the largest E.  Checked by tests/fabric/test_orientation.cpp
[[nodiscard]] double density(double polar_angle, double anisotropy);

/// F11 = (5-3a)/(5(3-a)), F33 = (5+a)/(5(3-a)).
/// \param    anisotropy   a in [-5, 5/3]: outside, no set of unit vectors has these moments
/// \throws   InvalidArgument outside that range
/// Accuracy  3 ulp.  Checked by tests/fabric/test_orientation.cpp
[[nodiscard]] SecondMoments second_moments(double anisotropy);

/// <n1^4> = 3(7-5a)/D, <n3^4> = 3(7+3a)/D, <n1^2 n2^2> = (7-5a)/D, <n1^2 n3^2> = (7-a)/D, D = 35(3-a).
/// \param    anisotropy   a in [-7/3, 7/5]: outside, a mean of fourth powers would be negative
/// \throws   InvalidArgument outside that range
/// Accuracy  3 ulp.  Checked by tests/fabric/test_orientation.cpp
[[nodiscard]] FourthMoments fourth_moments(double anisotropy);

/// a = 5(3 F33 - 1)/(5 F33 + 1), the inverse of second_moments. Never clipped: |a| > 1 comes back as it is,
/// see anisotropy_validity.
/// \param    F33   mean of n3^2, in [0, 1]
/// \throws   InvalidArgument if F33 is outside [0, 1]
/// Accuracy  absolute 1e-15 near a = 0.  Checked by tests/fabric/test_orientation.cpp
[[nodiscard]] double anisotropy_from_F33(double F33);

/// A note if |a| > 1: E(gamma; a) is then negative in some directions, so the contacts are more strongly
/// oriented than this family of densities can describe.
[[nodiscard]] Validity anisotropy_validity(double anisotropy);

} // namespace granum::fabric
