// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <granum/core/error.hpp>
#include <granum/core/vec3.hpp>

namespace granum::fabric {

/// Fabric anisotropy measured on a sample of contact normals.
struct AnisotropyEstimate {
  double anisotropy = 0;     ///< a of E(gamma; a), never clipped
  double standard_error = 0; ///< of a, for contacts drawn independently
  double F33 = 0;            ///< mean of n3^2
  std::size_t contacts = 0;
  Validity validity; ///< a note if |a| > 1
};

/// a of E(gamma; a) from the mean of n3^2, with da/dF33 times its standard error from the scatter of n3^2.
/// Assumes   axis 3 is the axis of symmetry. Contacts of a packing exclude one another on a grain, so that
///           they scatter less than independent ones: the error is on the safe side.
/// \param    normals   one unit vector a contact, either sense; at least 2
/// \throws   InvalidArgument for fewer than 2 normals, or one whose length differs from 1 by more than 1e-6
/// Accuracy  absolute 1e-15 sqrt(contacts).  Checked by tests/fabric/test_anisotropy_estimate.cpp
[[nodiscard]] AnisotropyEstimate estimate_anisotropy(std::span<const Vec3> normals);

/// Standard error of a for independent contacts of isotropic directions, sqrt(45/16)/sqrt(contacts): the
/// measure of what still counts as isotropic.
/// \param    contacts   N_c > 0
/// \throws   InvalidArgument for no contacts
/// Accuracy  2 ulp.  Checked by tests/fabric/test_anisotropy_estimate.cpp
[[nodiscard]] double isotropic_standard_error(std::size_t contacts);

/// Fabric anisotropy by maximum likelihood.
struct LikelihoodEstimate {
  double anisotropy = 0;          ///< a of E(gamma; a), the most likely one in [-1, 1]
  double standard_error = 0;      ///< of a, from the observed information; infinite if there is none
  double log_likelihood_gain = 0; ///< ln L(a) - ln L(0) >= 0: gain over isotropy
  bool at_boundary = false;       ///< a = -1 or 1 because the likelihood still rises there: the error is then
                                  ///< only a scale, the estimate is not normally distributed
  std::size_t contacts = 0;
  Validity validity; ///< a note at a boundary, or if the directions barely constrain a
};

/// a that makes the sample most likely. In terms of a_c = 4a/(3-a) the log-likelihood, the sum of
/// ln(1 + a_c P2(cos gamma)), is concave: there is one maximum, found by Newton's rule within a bracket.
/// Scatters less than the moment estimate (estimate_anisotropy) the further a is from 0, but leans on
/// E(gamma; a) being the density: test_density.
/// Assumes   axis 3 is the axis of symmetry, contacts drawn independently. Contacts of a packing exclude one
///           another on a grain, so that they scatter less: the error is on the safe side.
/// \param    normals   one unit vector a contact, either sense; at least 2
/// \throws   InvalidArgument for fewer than 2 normals, or one whose length differs from 1 by more than 1e-6
/// Accuracy  the maximum to 1e-14.  Checked by tests/fabric/test_likelihood_estimate.cpp
[[nodiscard]] LikelihoodEstimate estimate_anisotropy_by_likelihood(std::span<const Vec3> normals);

/// \file
/// Tests of contact normals against three hypotheses: isotropy, E(gamma; a), and symmetry about axis 3. A
/// p-value is the probability of a statistic at least as large under the hypothesis; a small one (say below
/// 0.01) speaks against it.
/// Assumes   contacts drawn independently. Contacts of a packing exclude one another on a grain, so that
///           they scatter less than independent ones: p-values are on the large side.
/// \param    normals   (of every function) one unit vector a contact, either sense
/// \throws   InvalidArgument for fewer normals than named, or one whose length differs from 1 by more than
///           1e-6
/// Accuracy  statistics to 1e-13, p-values 1e-12.  Checked by tests/fabric/test_goodness_of_fit.cpp

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

/// One bin of a histogram over the polar angle gamma in [0, pi/2], beside what E(gamma; a) leads one to
/// expect.
struct RoseBin {
  double low = 0;              ///< gamma [rad]
  double high = 0;             ///< gamma [rad]
  std::size_t count = 0;       ///< contacts with low <= gamma < high; the last bin includes pi/2
  double count_error = 0;      ///< sqrt(count)
  double expected_count = 0;   ///< N_c times the probability of the bin under E(gamma; a)
  double density = 0;          ///< count over N_c and the bin's solid angle in both hemispheres [1/sr]
  double density_error = 0;    ///< count_error over the same [1/sr]
  double expected_density = 0; ///< mean of E over the bin [1/sr]
};

/// Histogram of the angle between contact normals and axis 3, in bins of equal width.
/// \param    normals      one unit vector a contact, either sense; at least 1
/// \param    anisotropy   a of the density to compare with, in [-1, 1]
/// \param    bins         number of bins, in [1, 1000]
/// \throws   InvalidArgument outside these ranges, or for a normal whose length differs from 1 by more than
///           1e-6
/// Accuracy  1e-14 relative to the density's mean.  Checked by tests/fabric/test_rose.cpp
[[nodiscard]] std::vector<RoseBin> rose(std::span<const Vec3> normals, double anisotropy, std::size_t bins);

/// The histogram of counts in bins of equal width over [0, pi/2], as rose() has it of normals.
/// \param    counts   at least 1 bin, not all empty
/// \throws   InvalidArgument outside these ranges, or for an anisotropy as above
/// Accuracy  as rose().  Checked by tests/fabric/test_rose.cpp
[[nodiscard]] std::vector<RoseBin> rose_of_counts(std::span<const std::size_t> counts, double anisotropy);

/// A histogram for few contacts: neighbours are merged until the bin around axis 3, the smallest
/// solid angle, would contain 25 contacts for an isotropic fabric, so that its counting error is a
/// fifth; but at least 3 bins stay, where there are so many.
/// \param    anisotropy   a of the density to compare with, in [-1, 1]
/// \return   of n bins the most that divide n and do that
/// \throws   InvalidArgument as rose_of_counts
/// Checked by tests/fabric/test_rose.cpp
[[nodiscard]] std::vector<RoseBin> readable_rose(std::span<const std::size_t> counts, double anisotropy);

} // namespace granum::fabric
