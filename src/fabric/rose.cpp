// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/fabric/rose.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <granum/core/check.hpp>
#include <granum/fabric/polar_distribution.hpp>

#include "normals.hpp"

namespace granum::fabric {

namespace {

/// Acute angle with axis 3, without the loss of digits that the arc cosine has near it.
double polar_angle(const Vec3& n) { return std::atan2(std::sqrt(n.x * n.x + n.y * n.y), std::abs(n.z)); }

double share_above(double angle, double anisotropy) {
  return cumulative_probability(std::clamp(std::cos(angle), 0.0, 1.0), anisotropy);
}

} // namespace

std::vector<RoseBin> rose(std::span<const Vec3> normals, double anisotropy, std::size_t bins) {
  require_normals(normals, 1);
  require_closed("fabric_anisotropy", anisotropy, -1, 1);
  require_closed("bins", static_cast<double>(bins), 1, 1000);
  const double width = std::numbers::pi / 2 / static_cast<double>(bins);
  std::vector<RoseBin> histogram(bins);
  for (const Vec3& n : normals)
    ++histogram[std::min(static_cast<std::size_t>(polar_angle(n) / width), bins - 1)].count;

  const auto contacts = static_cast<double>(normals.size());
  for (std::size_t i = 0; i < bins; ++i) {
    RoseBin& bin = histogram[i];
    bin.low = static_cast<double>(i) * width;
    bin.high = static_cast<double>(i + 1) * width;
    // 4 pi (cos low - cos high)
    const double solid_angle =
        8 * std::numbers::pi * std::sin((bin.low + bin.high) / 2) * std::sin((bin.high - bin.low) / 2);
    bin.count_error = std::sqrt(static_cast<double>(bin.count));
    bin.expected_count = contacts * (share_above(bin.low, anisotropy) - share_above(bin.high, anisotropy));
    bin.density = static_cast<double>(bin.count) / (contacts * solid_angle);
    bin.density_error = bin.count_error / (contacts * solid_angle);
    bin.expected_density = bin.expected_count / (contacts * solid_angle);
  }
  return histogram;
}

} // namespace granum::fabric
