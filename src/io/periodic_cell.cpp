// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing_builder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace granum::io {

namespace {

void set_column(Mat3& m, int k, const Vec3& v) {
  for (int row = 0; row < 3; ++row)
    m(row, k) = v[row];
}

} // namespace

bool is_upside_down(const Mat3& cell) {
  const bool triangular = cell(1, 0) == 0 && cell(2, 0) == 0 && cell(2, 1) == 0;
  return triangular && (cell(0, 0) < 0 || cell(1, 1) < 0 || cell(2, 2) < 0);
}

bool reduce_cell(Mat3& cell, const std::array<bool, 3>& periodic) {
  constexpr double half = 0.5 + 1e-3; // as far as codes let boxes lean, and rounding
  constexpr int most = 200;
  bool reduced = false, again = true;
  for (int turn = 0; again && turn < most; ++turn) {
    again = false;
    for (int k = 0; k < 3; ++k)
      for (int other = 0; other < 3; ++other) {
        if (k == other || !periodic[static_cast<std::size_t>(k)] ||
            !periodic[static_cast<std::size_t>(other)])
          continue;
        const Vec3 edge = column(cell, k), along = column(cell, other);
        const double lean = dot(edge, along) / dot(along, along);
        if (!(std::abs(lean) > half) || !std::isfinite(lean))
          continue;
        const Vec3 shorter = edge - std::round(lean) * along;
        if (!(norm(shorter) < norm(edge)))
          continue;
        set_column(cell, k, shorter);
        reduced = again = true;
      }
  }
  return reduced;
}

void swap_edges(Mat3& cell) {
  const Vec3 first = column(cell, 0);
  set_column(cell, 0, column(cell, 1));
  set_column(cell, 1, first);
}

PeriodicCell::PeriodicCell(const Mat3& edges, const std::array<bool, 3>& periodic)
    : edges_(edges), inverse_(inverse_of(edges)), periodic_(periodic) {
  safe_length_ = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k)
    if (periodic_[static_cast<std::size_t>(k)]) { // the faces lie 1/|row k of the inverse| apart
      const Vec3 row{inverse_(k, 0), inverse_(k, 1), inverse_(k, 2)};
      safe_length_ = std::min(safe_length_, 0.5 / norm(row));
    }
}

Vec3 PeriodicCell::shifted(Vec3 difference, int a, int b, int c) const {
  const int steps[3] = {a, b, c};
  for (int k = 0; k < 3; ++k)
    if (periodic_[static_cast<std::size_t>(k)])
      difference += steps[k] * column(edges_, k);
  return difference;
}

Vec3 PeriodicCell::nearest(const Vec3& difference) const {
  const Vec3 fraction = inverse_ * difference;
  Vec3 rounded = difference;
  for (int k = 0; k < 3; ++k)
    if (periodic_[static_cast<std::size_t>(k)])
      if (const double turns = std::round(fraction[k]); turns != 0)
        rounded -= turns * column(edges_, k);
  if (norm(rounded) <= safe_length_)
    return rounded;
  Vec3 best = rounded;
  for (int a = -1; a <= 1; ++a)
    for (int b = -1; b <= 1; ++b)
      for (int c = -1; c <= 1; ++c)
        if (const Vec3 image = shifted(rounded, a, b, c); norm(image) < norm(best))
          best = image;
  return best;
}

std::vector<Vec3> PeriodicCell::images(const Vec3& difference, double length) const {
  const Vec3 shortest = nearest(difference);
  std::vector<Vec3> out{shortest};
  if (length < safe_length_) // two images differ by an edge at least
    return out;
  constexpr int around = 2; // cells may lean
  const auto steps = [this](std::size_t k) { return periodic_[k] ? around : 0; };
  for (int a = -steps(0); a <= steps(0); ++a)
    for (int b = -steps(1); b <= steps(1); ++b)
      for (int c = -steps(2); c <= steps(2); ++c)
        if (const Vec3 image = shifted(shortest, a, b, c);
            (a != 0 || b != 0 || c != 0) && norm(image) <= length)
          out.push_back(image);
  std::stable_sort(out.begin(), out.end(), [](const Vec3& x, const Vec3& y) { return norm(x) < norm(y); });
  return out;
}

} // namespace granum::io
