// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/packing/interior.hpp>

#include <algorithm>

#include <granum/core/check.hpp>
#include <granum/core/error.hpp>
#include <granum/packing/assembly.hpp>

#include "cut_sphere.hpp"

namespace granum::packing {

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

} // namespace granum::packing
