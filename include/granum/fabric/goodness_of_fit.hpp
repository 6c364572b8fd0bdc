// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include <granum/core/vec3.hpp>

/// Tests of contact normals against three hypotheses: isotropy, E(gamma; a), and symmetry about axis 3. A
/// p-value is the probability of a statistic at least as large under the hypothesis; a small one (say below
/// 0.01) speaks against it.
/// Assumes   contacts drawn independently. Contacts of a packing exclude one another on a grain, so that
///           they scatter less than independent ones: p-values are on the large side.
/// \param    normals   (of every function) one unit vector a contact, either sense
/// \throws   InvalidArgument for fewer normals than named, or one whose length differs from 1 by more than
///           1e-6
/// Accuracy  statistics to 1e-13, p-values 1e-12.  Checked by tests/fabric/test_goodness_of_fit.cpp
namespace granum::fabric {

/// A statistic that follows the chi-square distribution under the hypothesis.
struct ChiSquareTest {
  double statistic = 0;
  int degrees_of_freedom = 0;
  double p_value = 1;
};

/// Is a different from 0?
struct IsotropyTest {
  double z_score = 0;             ///< (F33 - 1/3)/sqrt(4/(45 N_c)): normal, mean 0, variance 1 if isotropic
  double p_value = 1;             ///< of |z_score|, either sign
  ChiSquareTest likelihood_ratio; ///< 2 (ln L(a) - ln L(0)) of the most likely a in [-1, 1]
};

/// Needs at least 2 normals.
[[nodiscard]] IsotropyTest test_isotropy(std::span<const Vec3> normals);

/// Does E(gamma; a) describe the directions? Pearson's statistic of the counts of |n3| in bins of equal
/// probability.
struct DensityTest {
  double anisotropy = 0; ///< a that was tested
  std::size_t bins = 0;  ///< largest k with k <= 2 N_c^(2/5), at least 5 contacts expected in each
  ChiSquareTest chi_square;
};

/// For an a known beforehand: bins - 1 degrees of freedom.                                    [DAgostino1986]
/// \param    anisotropy   a in [-1, 1]
/// Needs at least 20 normals.
[[nodiscard]] DensityTest test_density(std::span<const Vec3> normals, double anisotropy);
/// For the most likely a of this very sample: bins - 2 degrees of freedom, which puts the p-value slightly
/// low, as a was fitted to the directions and not to the counts.                        [ChernoffLehmann1954]
/// Needs at least 20 normals.
[[nodiscard]] DensityTest test_density(std::span<const Vec3> normals);

/// Is axis 3 an axis of symmetry of the fabric tensor? Squared means of (n1^2-n2^2)/2, n1 n2, n1 n3 and n2 n3
/// over their variances, which under symmetry are uncorrelated: four degrees of freedom in two pairs.
struct AxisymmetryTest {
  ChiSquareTest horizontal; ///< F11 = F22 and F12 = 0
  ChiSquareTest tilt;       ///< F13 = F23 = 0
  ChiSquareTest both;       ///< their sum
};

/// Needs at least 20 normals. Where all normals are vertical, or all horizontal, what cannot vary takes no
/// part and has no degrees of freedom.
[[nodiscard]] AxisymmetryTest test_axisymmetry(std::span<const Vec3> normals);

} // namespace granum::fabric
