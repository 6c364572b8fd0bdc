// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/packing/interior.hpp>

#include <algorithm>
#include <cmath>
#include <string>

#include <granum/core/check.hpp>
#include <granum/core/error.hpp>
#include <granum/core/number.hpp>
#include <granum/packing/assembly.hpp>

#include "cut_sphere.hpp"

namespace granum::packing {

Interior::Interior(const Mat3& cell, double layer)
    : to_fraction_(inverse_of(cell)), widths_(cell_widths(cell)) {
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

Interior::Interior(const Mat3& cell, const Vec3& low, const Vec3& high)
    : origin_(low), cell_(cell), to_cell_(inverse_of(cell)) {
  const char* const axis[] = {"x", "y", "z"};
  const Vec3 reach = cell_widths(cell);
  for (int k = 0; k < 3; ++k) {
    constexpr double rounding = 1e-9;
    widths_[k] = high[k] - low[k];
    if (!(widths_[k] > 0) || !(widths_[k] <= (1 + rounding) * reach[k]))
      throw InvalidArgument(std::string("width of the window along ") + axis[k], widths_[k], "m",
                            "(0, " + short_text(reach[k], 6) + " m], the width of the cell");
  }
  to_fraction_ = Mat3::diagonal(1 / widths_.x, 1 / widths_.y, 1 / widths_.z);
  volume_ = widths_.x * widths_.y * widths_.z;
  for (int kx = -1; kx <= 1; ++kx)
    for (int ky = -1; ky <= 1; ++ky)
      for (int kz = -1; kz <= 1; ++kz)
        shifts_.push_back(cell *
                          Vec3{static_cast<double>(kx), static_cast<double>(ky), static_cast<double>(kz)});
}

template <class See>
void Interior::images(const Vec3& x, const See& see) const {
  if (shifts_.empty())
    return see(to_fraction_ * x);
  // the image nearest to the middle of the window, and those around it
  Vec3 home = x - (origin_ + 0.5 * widths_);
  const Vec3 s = to_cell_ * home;
  home -= cell_ * Vec3{std::round(s.x), std::round(s.y), std::round(s.z)};
  for (const Vec3& shift : shifts_)
    see(to_fraction_ * (home + shift + 0.5 * widths_));
}

bool Interior::holds(const Vec3& x) const {
  bool inside = false;
  images(x, [&](const Vec3& s) { inside = inside || holds_here(s); });
  return inside;
}

double Interior::part_of_sphere(const Vec3& x, double radius) const {
  require_positive("radius", radius, "m");
  double part = 0;
  images(x, [&](const Vec3& s) { part += part_here(s, radius); });
  return part;
}

double Interior::share(const Vec3& x, const Vec3& branch) const {
  const Vec3 t = to_fraction_ * branch;
  double share = 0;
  images(x, [&](const Vec3& s) { share += share_here(s, t); });
  return share;
}

bool Interior::holds_here(const Vec3& s) const {
  for (int k = 0; k < 3; ++k)
    if (s[k] < margin_[k] || s[k] > 1 - margin_[k])
      return false;
  return true;
}

double Interior::part_here(const Vec3& s, double radius) const {
  Vec3 low, high;
  for (int k = 0; k < 3; ++k) {
    low[k] = widths_[k] / radius * (margin_[k] - s[k]);
    high[k] = widths_[k] / radius * (1 - margin_[k] - s[k]);
  }
  return radius * radius * radius * unit_sphere_in_box(low, high);
}

double Interior::share_here(const Vec3& s, const Vec3& t) const {
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
