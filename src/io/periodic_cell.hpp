// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include <granum/core/vec3.hpp>

namespace granum::io {

/// A cell of which some pairs of faces are periodic.
class PeriodicCell {
 public:
  PeriodicCell() = default;
  /// Assumes a finite volume other than zero.
  PeriodicCell(const Mat3& edges, const std::array<bool, 3>& periodic);

  /// The shortest periodic image of a difference of two positions.
  [[nodiscard]] Vec3 nearest(const Vec3& difference) const;

 private:
  [[nodiscard]] Vec3 shifted(Vec3 difference, int a, int b, int c) const;

  Mat3 edges_;
  Mat3 inverse_;
  std::array<bool, 3> periodic_{};
  double safe_length_ = 0; ///< up to it, the image found by rounding is the shortest
};

} // namespace granum::io
