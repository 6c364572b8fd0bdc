// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <granum/packing/assembly.hpp>

namespace granum::packing {

/// Normal forces of all contacts, in their order [N].
[[nodiscard]] std::vector<double> normal_forces(const Assembly& assembly);

/// One bin of a histogram over x = f_n/<f_n>.
struct ForceBin {
  double low = 0; ///< x
  double high = 0;
  std::size_t count = 0;    ///< contacts with low <= x < high
  double density = 0;       ///< share of the pressing contacts over the width of the bin [1]
  double density_error = 0; ///< sqrt(count) over the same [1]
};

/// How normal forces are distributed about their mean.
struct ForceDistribution {
  std::size_t pressing = 0;   ///< contacts with f_n > 0: those of the histogram and of the mean
  std::size_t unloaded = 0;   ///< f_n = 0
  std::size_t in_tension = 0; ///< f_n < 0
  double mean = 0;            ///< <f_n> [N]; 0 if none presses
  double largest = 0;         ///< [N]
  std::vector<ForceBin> bins; ///< of equal width
  std::size_t beyond = 0;     ///< pressing contacts above the last bin
};

/// \param    forces     normal forces, compression positive, finite [N]
/// \param    bins       in [1, 1000]
/// \param    range      upper end of the last bin, f_n/<f_n> > 0 [1]
/// \throws   InvalidArgument outside these ranges
/// Accuracy  rounding.  Checked by tests/packing/test_force_distribution.cpp
[[nodiscard]] ForceDistribution force_distribution(std::span<const double> forces, std::size_t bins = 32,
                                                   double range = 8);

} // namespace granum::packing
