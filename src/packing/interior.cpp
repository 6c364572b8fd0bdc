// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/packing/interior.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <granum/core/error.hpp>
#include <granum/core/numerics.hpp>
#include <granum/core/text.hpp>
#include <granum/packing/assembly.hpp>

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

/// Volume of the unit ball about the origin that lies in the box from low to high, low <= high.
/// Accuracy  1e-10: closed form where one axis cuts it, Gauss quadrature of closed-form sections elsewhere.
///           Checked by tests/packing/test_interior.cpp
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

} // namespace

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
                            "(0, " + short_text(reach[k], 10) + " m], the width of the cell");
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
