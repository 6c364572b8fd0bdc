// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <granum/core/error.hpp>
#include <granum/core/vec3.hpp>

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

/// \file
/// How contact normals of density E(gamma; a) are distributed over t = |n3|, the cosine of the acute angle
/// between normal and axis: P(t) = t (3(1-a) + 2 a t^2)/(3-a).
/// Checked by tests/fabric/test_polar_distribution.cpp

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

/// \file
/// One axisymmetric fabric in the notations that are in use, each made from any other.
/// Checked by tests/fabric/test_measures.cpp

/// Measures of one fabric. They are moments of second order and as such exist for every set of contacts;
/// E(gamma; a) is a density only for |a| <= 1, that is F33 in [0.2, 0.6] and P2 coefficient in [-1, 2].
/// Values outside come back as they are, with a note.
struct FabricMeasures {
  double anisotropy = 0;             ///< a of E(gamma; a), in [-5, 5/3]
  double F11 = 1.0 / 3;              ///< mean of n1^2, in [0, 1/2]
  double F33 = 1.0 / 3;              ///< mean of n3^2, in [0, 1]
  double P2_coefficient = 0;         ///< a_c of E = (1 + a_c P2(cos gamma))/(4 pi), in [-5/2, 5]; at the same
                                     ///< time the 33 component of contact_tensor
  double mean_cos_2gamma = -1.0 / 3; ///< 2 F33 - 1, in [-1, 1]
  Validity validity;                 ///< a note if |a| > 1
};

/// From a: a_c = 4a/(3-a).                                                                [Chung2014, Eq. 10]
/// \throws   InvalidArgument unless a is in [-5, 5/3]: no set of unit vectors has another
/// Accuracy  a and a_c 4 ulp, the others 4 ulp of 1; so also below.
[[nodiscard]] FabricMeasures measures_from_anisotropy(double anisotropy);
/// From the mean of n3^2: a_c = 5(3 F33 - 1)/2.
/// \throws   InvalidArgument unless F33 is in [0, 1]
[[nodiscard]] FabricMeasures measures_from_F33(double F33);
/// From the coefficient of P2, or the 33 component of a contact tensor: a = 3 a_c/(4 + a_c).
/// \throws   InvalidArgument unless the coefficient is in [-5/2, 5]
[[nodiscard]] FabricMeasures measures_from_P2_coefficient(double P2_coefficient);
/// From the mean of cos 2 gamma: a = 5(1+3c)/(7+5c).
/// \throws   InvalidArgument unless the mean is in [-1, 1]
[[nodiscard]] FabricMeasures measures_from_mean_cos_2gamma(double mean_cos_2gamma);

/// Traceless contact tensor 15/2 (F - 1/3), as LAMMPS' compute fabric writes it.               [Kanatani1984]
/// \param    fabric   mean of n_i n_j, symmetric within 1e-3 of its largest entry, trace 1 within 1e-6
/// \throws   InvalidArgument for another matrix
/// Accuracy  rounding of F.
[[nodiscard]] Mat3 contact_tensor(const Mat3& fabric);
/// F = 1/3 + 2/15 A, the inverse of the above.
/// \param    contact_tensor   A, symmetric within 1e-3 of its largest entry, trace 0 within 1e-5
/// \throws   InvalidArgument for another matrix
[[nodiscard]] Mat3 fabric_from_contact_tensor(const Mat3& contact_tensor);

/// Unit vectors drawn independently from E(gamma; a): n3 by the inverse of its distribution, the azimuth by a
/// point in the unit disc [Marsaglia1972]. Random bits by Boost, then sums, products, quotients and square
/// roots only: the same seed gives the same bits on every machine. A longer sample begins with the shorter.
/// \param    anisotropy   a in [-1, 1]
/// \param    count        number of vectors, 0 allowed
/// \param    seed         any number; one seed, one sample
/// \throws   InvalidArgument if a is outside [-1, 1]
/// Accuracy  of unit length to 4 ulp.  Checked by tests/fabric/test_sampling.cpp
[[nodiscard]] std::vector<Vec3> sample_normals(double anisotropy, std::size_t count, std::uint64_t seed);

} // namespace granum::fabric
