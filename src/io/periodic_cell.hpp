// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include <granum/core/vec3.hpp>

namespace granum::io {

/// Whether an edge of a box along the axes, or of LAMMPS' tilted ones, ends before it begins: no order of
/// edges corrects bounds in reverse order.
[[nodiscard]] bool is_upside_down(const Mat3& cell);

/// Shortens periodic edges by others until none leans by more than half of another: a cell of the same
/// lattice, in which the images nearest to one another are next to one another.
/// \return   whether anything was to be done
bool reduce_cell(Mat3& cell, const std::array<bool, 3>& periodic);

/// The first two edges in each other's place: a right-handed cell of a left-handed one.
void swap_edges(Mat3& cell);

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
