// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include <granum/core/vec3.hpp>
#include <granum/dem/specimen.hpp>

/// Six rigid plane walls, the faces of the cell, in place of periodicity. A wall moves with the centre of its
/// face and rotates with it, as a rigid plate; shear of the cell tilts a pair of opposite walls. A contact
/// with a rigid plane equals, by symmetry, half of the contact of a grain with its mirror image. With the
/// pair law f = F(d), a grain whose centre is R - d_w from the wall has f = F(2 d_w), k_n = 2 F'(2 d_w).
/// k_t/k_n is that of the grains. Rough walls carry a part of each other's stress by friction.
/// Checked by tests/dem/test_walls.cpp
namespace granum::dem {

/// One wall; wall 2k is the face through the cell's origin across edge k, 2k + 1 the opposite one.
struct WallPlane {
  Vec3 centre;     ///< of the face [m]
  Vec3 normal;     ///< unit, into the cell
  double area = 0; ///< [m^2]
};

inline constexpr std::size_t wall_count = 6;

/// Assumes   a cell of positive volume.
[[nodiscard]] std::array<WallPlane, wall_count> wall_planes(const Mat3& cell);

/// Forces of the walls on the grains, and the resulting normal stresses.
struct WallForces {
  std::array<Vec3, wall_count> force; ///< from each wall on the grains [N]
  std::size_t contacts = 0;
  std::size_t sliding = 0;
};

/// Reaction over area: the normal stress on each axis, mean of its two walls [Pa].
[[nodiscard]] Vec3 wall_stress(const WallForces& forces, const std::array<WallPlane, wall_count>& planes);

} // namespace granum::dem
