// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/fabric/rose.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <granum/core/error.hpp>
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

std::vector<RoseBin> rose_of_counts(std::span<const std::size_t> counts, double anisotropy) {
  require_closed("fabric_anisotropy", anisotropy, -1, 1);
  require_closed("bins", static_cast<double>(counts.size()), 1, 1000);
  const auto contacts = static_cast<double>(std::accumulate(counts.begin(), counts.end(), std::size_t{0}));
  require_positive("contacts", contacts);
  const double width = std::numbers::pi / 2 / static_cast<double>(counts.size());
  std::vector<RoseBin> histogram(counts.size());
  for (std::size_t i = 0; i < histogram.size(); ++i) {
    RoseBin& bin = histogram[i];
    bin.count = counts[i];
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

std::vector<RoseBin> rose(std::span<const Vec3> normals, double anisotropy, std::size_t bins) {
  require_normals(normals, 1);
  require_closed("bins", static_cast<double>(bins), 1, 1000);
  const double width = std::numbers::pi / 2 / static_cast<double>(bins);
  std::vector<std::size_t> counts(bins);
  for (std::size_t k = 0; k < normals.size(); ++k) {
    stop_point(k);
    ++counts[std::min(static_cast<std::size_t>(polar_angle(normals[k]) / width), bins - 1)];
  }
  return rose_of_counts(counts, anisotropy);
}

std::vector<RoseBin> readable_rose(std::span<const std::size_t> counts, double anisotropy) {
  constexpr double enough = 25; // contacts
  constexpr std::size_t least_bins = 3;
  const auto contacts = static_cast<double>(std::accumulate(counts.begin(), counts.end(), std::size_t{0}));
  const std::size_t bins = counts.size();
  std::size_t taken = 1; // into one
  for (std::size_t next = 1; next <= bins && bins / next >= std::min(bins, least_bins); ++next) {
    if (bins % next != 0)
      continue;
    taken = next;
    const double width = std::numbers::pi / 2 * static_cast<double>(taken) / static_cast<double>(bins);
    if (contacts * (1 - std::cos(width)) >= enough)
      break;
  }
  std::vector<std::size_t> merged(bins / taken);
  for (std::size_t i = 0; i < bins; ++i)
    merged[i / taken] += counts[i];
  return rose_of_counts(merged, anisotropy);
}

} // namespace granum::fabric
