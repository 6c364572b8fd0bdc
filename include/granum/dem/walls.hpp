// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include <granum/core/vec3.hpp>
#include <granum/dem/specimen.hpp>

/// Six rigid plane walls, the faces of the cell, in place of its periodicity.
///
/// A wall moves as a rigid plate: with the centre of its face, and turning with its face, so that a sheared
/// cell tilts a pair of opposite walls. Its contact is that of a rigid plane: by symmetry a grain and its
/// mirror image meet at such a plane, each having approached it by half of their overlap, so with the pair
/// law f = F(d) a grain of the size of that law whose centre is R - d_w from the wall bears f = F(2 d_w),
/// k_n = 2 F'(2 d_w). The ratio k_t/k_n is the grains'. Rough walls bear a part of each other's stress by
/// friction.
/// Checked by tests/dem/test_walls.cpp
namespace granum::dem {

/// One wall as it stands; wall 2k is the face through the cell's origin across edge k, 2k + 1 the other one.
struct WallPlane {
  Vec3 centre;     ///< of the face [m]
  Vec3 normal;     ///< unit, into the cell
  double area = 0; ///< [m^2]
};

inline constexpr std::size_t wall_count = 6;

/// Assumes   a cell of positive volume.
[[nodiscard]] std::array<WallPlane, wall_count> wall_planes(const Mat3& cell);

/// Forces on the grains from the walls, and how they compare with the contact stress.
struct WallForces {
  std::array<Vec3, wall_count> force; ///< from each wall on the grains [N]
  std::size_t contacts = 0;
  std::size_t sliding = 0;
};

/// Reaction over area: the normal stress on each axis, mean of its two walls [Pa].
[[nodiscard]] Vec3 wall_stress(const WallForces& forces, const std::array<WallPlane, wall_count>& planes);

} // namespace granum::dem
