// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/dem/walls.hpp>

#include <algorithm>

#include <granum/core/check.hpp>
#include <granum/core/error.hpp>
#include <granum/dem/neighbours.hpp>

#include "cut_sphere.hpp"

namespace granum::dem {

std::array<WallPlane, wall_count> wall_planes(const Mat3& cell) {
  std::array<WallPlane, wall_count> planes;
  for (int k = 0; k < 3; ++k) {
    const Vec3 across = column(cell, k), u = column(cell, (k + 1) % 3), v = column(cell, (k + 2) % 3);
    const Vec3 face = cross(u, v);
    const double area = norm(face);
    const Vec3 normal = (1 / area) * face;
    const Vec3 centre = 0.5 * (u + v);
    const auto lower = static_cast<std::size_t>(2 * k);
    planes[lower] = {centre, normal, area};
    planes[lower + 1] = {centre + across, -normal, area};
  }
  return planes;
}

Vec3 wall_stress(const WallForces& forces, const std::array<WallPlane, wall_count>& planes) {
  Vec3 stress;
  for (std::size_t w = 0; w < wall_count; ++w)
    stress[static_cast<int>(w / 2)] += dot(forces.force[w], planes[w].normal) / planes[w].area / 2;
  return stress;
}

Interior::Interior(const Mat3& cell, double layer) : to_fraction_(inverse(cell)), widths_(cell_widths(cell)) {
  require_non_negative("layer", layer, "m");
  double share = 1;
  for (int k = 0; k < 3; ++k) {
    margin_[k] = layer / widths_[k];
    share *= 1 - 2 * margin_[k];
    if (!(2 * margin_[k] < 1))
      throw InvalidArgument("layer at the walls", layer, "m", "[0, half of the box)");
  }
  volume_ = share * determinant(cell);
}

bool Interior::holds(const Vec3& x) const {
  const Vec3 s = to_fraction_ * x;
  for (int k = 0; k < 3; ++k)
    if (s[k] < margin_[k] || s[k] > 1 - margin_[k])
      return false;
  return true;
}

double Interior::part_of_sphere(const Vec3& x, double radius) const {
  require_positive("radius", radius, "m");
  const Vec3 s = to_fraction_ * x;
  Vec3 low, high;
  for (int k = 0; k < 3; ++k) {
    low[k] = widths_[k] / radius * (margin_[k] - s[k]);
    high[k] = widths_[k] / radius * (1 - margin_[k] - s[k]);
  }
  return radius * radius * radius * unit_sphere_in_box(low, high);
}

double Interior::share(const Vec3& x, const Vec3& branch) const {
  const Vec3 s = to_fraction_ * x, t = to_fraction_ * branch;
  double enters = 0, leaves = 1;
  for (int k = 0; k < 3; ++k) {
    const double low = margin_[k] - s[k], high = 1 - margin_[k] - s[k];
    if (t[k] == 0) {
      if (low > 0 || high < 0)
        return 0;
      continue;
    }
    enters = std::max(enters, std::min(low / t[k], high / t[k]));
    leaves = std::min(leaves, std::max(low / t[k], high / t[k]));
  }
  return std::max(0.0, leaves - enters);
}

} // namespace granum::dem
