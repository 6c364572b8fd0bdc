// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/network. Unit strains in the order 11 22 33 23 13 12, engineering shears, and what they do.
#pragma once

#include <Eigen/Core>

#include <granum/core/vec3.hpp>

#include "lanes.hpp"

namespace granum::network {

/// A vector for each load case.
using Strain = Eigen::Matrix<double, 3, load_cases>;

inline Eigen::Vector3d eigen(const Vec3& v) { return {v.x, v.y, v.z}; }

/// n x, as a matrix.
inline Eigen::Matrix3d cross_matrix(const Vec3& n) {
  Eigen::Matrix3d m;
  m << 0, -n.z, n.y, n.z, 0, -n.x, -n.y, n.x, 0;
  return m;
}

inline Eigen::Matrix3d unit_strain(int load_case) {
  constexpr int rows[] = {0, 1, 2, 1, 0, 0}, columns[] = {0, 1, 2, 2, 2, 1};
  Eigen::Matrix3d e = Eigen::Matrix3d::Zero();
  e(rows[load_case], columns[load_case]) += 0.5;
  e(columns[load_case], rows[load_case]) += 0.5;
  return e;
}

/// Relative displacement of the two ends of a branch b for unit strains.
inline Strain branch_strain(const Vec3& b) {
  Strain e;
  e << b.x, 0, 0, 0, b.z / 2, b.y / 2, //
      0, b.y, 0, b.z / 2, 0, b.x / 2,  //
      0, 0, b.z, b.y / 2, b.x / 2, 0;
  return e;
}

} // namespace granum::network
