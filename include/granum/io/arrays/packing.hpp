// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>

#include <granum/io/imported_packing.hpp>

/// Packings from arrays in memory, from a coupled code or a script.
/// Checked by tests/io/arrays/test_packing.cpp
namespace granum::io {

/// Contacts between grains, and of grains with walls; each array empty or one element a contact. SI,
/// compression positive. A second number w < 0 is the wall -1 - w; its branch, which is needed, goes from
/// the centre to the wall, and its overlap is the radius less the length of the branch.
struct ContactArrays {
  std::span<const std::array<long, 2>> grains;       ///< first and second grain, numbered from 0
  std::span<const Vec3> branch = {};                 ///< centre of 2 minus centre of 1; nearest images [m]
  std::span<const double> overlap = {};              ///< full approach; from the radii [m]
  std::span<const Vec3> force = {};                  ///< whole force exerted by 1 on 2 [N], or its parts:
  std::span<const double> normal_force = {};         ///< compression positive [N]
  std::span<const Vec3> tangential_force = {};       ///< exerted by 1 on 2 [N]
  std::span<const double> normal_stiffness = {};     ///< k_n [N/m]
  std::span<const double> tangential_stiffness = {}; ///< k_t [N/m]
  std::span<const bool> sliding = {};                ///< at the Coulomb limit
  std::span<const double> rolling_stiffness = {};    ///< moment over angle [N m]
  std::span<const double> twisting_stiffness = {};   ///< [N m]
};

/// Grains, their cell, and contacts if known.
struct PackingArrays {
  std::span<const Vec3> position;                 ///< centres [m]
  std::span<const double> radius;                 ///< > 0, one for each centre [m]
  std::optional<Mat3> cell = {};                  ///< columns are its edges; the smallest box [m]
  std::array<bool, 3> periodic{true, true, true}; ///< pairs of faces of the cell
  /// Of each grain, no two the same; from 0 in the order of the grains, which ids do not change.
  std::span<const long> id = {};
  std::span<const long> body = {}; ///< of each grain, number of the rigid body it is a part of; < 0: of none
  std::optional<ContactArrays> contacts = {};
};

/// The packing, checked and sorted as from files: each contact once with i < j, notes on findings and missing
/// data. Without a cell the smallest upright box is used, and nothing is periodic.
/// \throws   InvalidArgument naming the array and its element: lengths that differ, a radius that is not
///           positive, a cell without volume, an unknown grain, a grain in contact with itself or across a
///           gap, one pair with two forces, numbers that are not finite; or for a force in whole and in parts
[[nodiscard]] ImportedPacking packing_of(const PackingArrays& arrays);

} // namespace granum::io
