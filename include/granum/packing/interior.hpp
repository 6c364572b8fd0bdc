// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <granum/core/vec3.hpp>

namespace granum::packing {

/// A part of a box: at a distance from every wall, or a window.
class Interior {
 public:
  /// \param    layer  >= 0, left out at each wall [m]
  /// \throws   InvalidArgument if nothing remains between the layers
  Interior(const Mat3& cell, double layer);
  /// An upright window of a packing; grains that reach into it through faces of the cell, which count as
  /// periodic, are cut without images.
  /// \throws   InvalidArgument for a window without volume, or wider along an axis than the cell is
  Interior(const Mat3& cell, const Vec3& low, const Vec3& high);

  [[nodiscard]] bool holds(const Vec3& x) const;
  /// Share of the straight line from x to x + branch that lies inside.
  [[nodiscard]] double share(const Vec3& x, const Vec3& branch) const;
  [[nodiscard]] double volume() const { return volume_; } ///< [m^3]
  /// Volume of the part of a sphere that lies inside.
  /// Assumes   faces at right angles to each other; where the box leans, spheres at its edges are off by as
  ///           much.
  /// \param    radius  > 0 [m]
  /// \return   [m^3]
  /// Accuracy  1e-10 of the sphere: closed form for spheres cut by one axis' faces, quadrature at edges and
  ///           corners.  Checked by tests/packing/test_interior.cpp
  [[nodiscard]] double part_of_sphere(const Vec3& x, double radius) const;

 private:
  [[nodiscard]] bool holds_here(const Vec3& s) const;
  [[nodiscard]] double part_here(const Vec3& s, double radius) const;
  [[nodiscard]] double share_here(const Vec3& s, const Vec3& t) const;
  /// Calls `see` with the fractional coordinates of each image of a point that may matter.
  template <class See>
  void images(const Vec3& x, const See& see) const;

  Mat3 to_fraction_;
  Vec3 origin_{};            ///< of the window [m]
  std::vector<Vec3> shifts_; ///< to the images of a grain; none where there is no window [m]
  Mat3 cell_{}, to_cell_{};  ///< of a window
  Vec3 widths_;              ///< of the cell [m]
  Vec3 margin_;              ///< in fractions of the edges
  double volume_ = 0;
};

} // namespace granum::packing
