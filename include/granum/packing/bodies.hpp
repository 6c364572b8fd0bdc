// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include <granum/packing/assembly.hpp>

namespace granum::packing {

/// An assembly of clumps, seen as one of rigid bodies.
struct Bodies {
  /// One grain a body: its centre of volume (members that overlap count twice), the radius of a sphere of its
  /// members' volume. Branches go from body to body, or from a body to the foot on a wall; forces are those
  /// of the contacts, so that the stress of this assembly is that of the bodies. Contacts inside of a body
  /// are left out. Its normals are branches, not normals of contacts: fabric is measured on the grains.
  Assembly assembly;
  std::vector<Vec3> offset;         ///< of each grain's centre from that of its body [m]
  std::vector<std::size_t> contact; ///< number in the grains' assembly that each contact has
};

/// The bodies of an assembly; grains without numbers of bodies are one each.
/// Assumes   members of a body are the nearest images of one another.
/// \throws   InvalidArgument for an assembly that require_valid rejects, or a body that touches its own image
/// Checked by tests/packing/test_bodies.cpp
[[nodiscard]] Bodies bodies(const Assembly& assembly);

} // namespace granum::packing
