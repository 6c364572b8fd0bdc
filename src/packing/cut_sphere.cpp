// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut_sphere.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <granum/core/quadrature.hpp>

namespace granum::packing {

namespace {

constexpr int nodes = 24;

/// Integral of min(sqrt(r^2 - x^2), c) from 0 to x, odd in x; c in [0, r], |x| <= r.
double clipped_semicircle(double r, double c, double x) {
  const auto semicircle = [&](double u) {
    const double ratio = std::min(1.0, u / r);
    return (u * std::sqrt(std::max(0.0, r * r - u * u)) + r * r * std::asin(ratio)) / 2;
  };
  const double size = std::abs(x), flat = std::sqrt(std::max(0.0, r * r - c * c));
  const double area = size <= flat ? c * size : c * flat + semicircle(size) - semicircle(flat);
  return std::copysign(area, x);
}

/// Area of the disc of radius r about the origin inside [low.x, high.x] x [low.y, high.y].
double disc_in_rectangle(double r, const Vec3& low, const Vec3& high) {
  const double from = std::clamp(low.x, -r, r), to = std::clamp(high.x, -r, r);
  const auto up_to = [&](double y) {
    const double c = std::min(r, std::abs(y));
    return std::copysign(clipped_semicircle(r, c, to) - clipped_semicircle(r, c, from), y);
  };
  return up_to(high.y) - up_to(low.y);
}

/// Heights at which the section's shape changes: its circle reaches a side or a corner of the rectangle.
std::vector<double> heights(const Vec3& low, const Vec3& high) {
  std::vector<double> at{low.z, high.z};
  const auto add = [&](double r_squared) {
    if (!(r_squared < 1))
      return;
    const double z = std::sqrt(1 - r_squared);
    for (const double height : {-z, z})
      if (low.z < height && height < high.z)
        at.push_back(height);
  };
  for (const double x : {low.x, high.x}) {
    add(x * x);
    for (const double y : {low.y, high.y})
      add(x * x + y * y);
  }
  for (const double y : {low.y, high.y})
    add(y * y);
  std::sort(at.begin(), at.end());
  return at;
}

} // namespace

double unit_sphere_in_box(Vec3 low, Vec3 high) {
  int cut_axes = 0, cut = 2;
  for (int k = 0; k < 3; ++k) {
    if (low[k] >= 1 || high[k] <= -1)
      return 0;
    low[k] = std::max(low[k], -1.0);
    high[k] = std::min(high[k], 1.0);
    if (low[k] > -1 || high[k] < 1) {
      ++cut_axes;
      cut = k;
    }
  }
  if (cut_axes <= 1) {
    const auto below = [](double h) { return std::numbers::pi * (h - h * h * h / 3); };
    return below(high[cut]) - below(low[cut]);
  }
  static const std::vector<QuadratureNode> rule = gauss_legendre(nodes);
  const std::vector<double> at = heights(low, high);
  double volume = 0;
  for (std::size_t k = 0; k + 1 < at.size(); ++k)
    for (const QuadratureNode& node : rule) {
      // The section changes as the power 3/2 of the way from a height: even in an angle.
      const double angle = std::numbers::pi / 2 * node.abscissa;
      const double z = (at[k] + at[k + 1] + (at[k + 1] - at[k]) * std::sin(angle)) / 2;
      const double weight = node.weight * std::numbers::pi / 4 * (at[k + 1] - at[k]) * std::cos(angle);
      volume += weight * disc_in_rectangle(std::sqrt(std::max(0.0, 1 - z * z)), low, high);
    }
  return volume;
}

} // namespace granum::packing
