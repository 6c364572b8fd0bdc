// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <granum/core/vec3.hpp>

namespace granum::fabric {

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
