// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include <granum/core/vec3.hpp>
#include <granum/elastic/stiffness.hpp>

/// A triclinic, symmetric, positive definite stiffness without any small entry [Pa].
inline granum::elastic::VoigtStiffness triclinic_sample() {
  granum::elastic::VoigtStiffness c;
  c.matrix << 310, 118, 133, 12, -7, 9, //
      118, 345, 127, -11, 14, 5,        //
      133, 127, 402, 8, 6, -13,         //
      12, -11, 8, 121, 10, -4,          //
      -7, 14, 6, 10, 115, 3,            //
      9, 5, -13, -4, 3, 96;
  c.matrix *= 1e6;
  return c;
}

/// Rotation by `angle` [rad] about the direction of `axis` (Rodrigues' formula).
inline granum::Mat3 rotation_about(granum::Vec3 axis, double angle) {
  using namespace granum;
  axis *= 1 / norm(axis);
  const Mat3 skew{{{0, -axis.z, axis.y}, {axis.z, 0, -axis.x}, {-axis.y, axis.x, 0}}};
  return Mat3::identity() + std::sin(angle) * skew + (1 - std::cos(angle)) * (skew * skew);
}
