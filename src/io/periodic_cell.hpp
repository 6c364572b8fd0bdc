// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

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
  /// All periodic images of a difference up to a length, the shortest first; the shortest in any case.
  /// Assumes   no grain of half that length reaches around the cell to itself.
  [[nodiscard]] std::vector<Vec3> images(const Vec3& difference, double length) const;

 private:
  [[nodiscard]] Vec3 shifted(Vec3 difference, int a, int b, int c) const;

  Mat3 edges_;
  Mat3 inverse_;
  std::array<bool, 3> periodic_{};
  double safe_length_ = 0; ///< up to it, the image found by rounding is the shortest
};

} // namespace granum::io
