// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include <granum/core/error.hpp>

namespace granum::sizes {

/// Radii in ascending order, each checked to be positive [m].
inline std::vector<double> sorted_radii(std::span<const double> radii) {
  for (const double radius : radii)
    require_positive("radius", radius, "m");
  std::vector<double> sorted(radii.begin(), radii.end());
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

} // namespace granum::sizes
