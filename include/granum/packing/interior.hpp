// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/core/vec3.hpp>

namespace granum::packing {

/// The part of a box that keeps a distance from every wall.
class Interior {
 public:
  /// \param    layer  >= 0, left out at each wall [m]
  /// \throws   InvalidArgument if the layers leave nothing
  Interior(const Mat3& cell, double layer);

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
  Mat3 to_fraction_;
  Vec3 widths_; ///< of the cell [m]
  Vec3 margin_; ///< in fractions of the edges
  double volume_ = 0;
};

} // namespace granum::packing
