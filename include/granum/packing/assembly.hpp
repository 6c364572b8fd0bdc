// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <granum/core/vec3.hpp>

/// The one neutral value type that specimens of the verifier and imported packings become.
namespace granum::packing {

/// One contact, i < j. Vectors point from grain i to grain j. A pair occurs once, but in cells
/// narrower than two diameters, where it may touch through several periodic images, once for each of them.
struct Contact {
  std::uint32_t i = 0;
  std::uint32_t j = 0;
  Vec3 branch{};                   ///< centre of j (the periodic image that touches) minus centre of i [m]
  double overlap = 0;              ///< R_i + R_j - |branch|, full approach [m]
  double normal_force = 0;         ///< compression positive [N]
  Vec3 tangential_force{};         ///< exerted by i on j, perpendicular to branch [N]
  double normal_stiffness = 0;     ///< k_n = df/dd at this state [N/m]
  double tangential_stiffness = 0; ///< k_t at this state [N/m]
  bool sliding = false;            ///< tangential force at the Coulomb limit
  double rolling_stiffness = 0;    ///< moment over angle, of two grains that roll on one another [N m]
  double twisting_stiffness = 0;   ///< the same about the normal [N m]

  bool operator==(const Contact&) const = default;
};

/// Unit normal from i to j.
[[nodiscard]] inline Vec3 normal(const Contact& c) { return (1 / norm(c.branch)) * c.branch; }
/// Whole force exerted by i on j [N].
[[nodiscard]] inline Vec3 force(const Contact& c) { return c.normal_force * normal(c) + c.tangential_force; }

/// Grains, contacts and their cell, periodic or bounded by rigid walls. Contacts are sorted by
/// (i, j).
struct Assembly {
  Mat3 cell;                     ///< columns are the three edge vectors [m]
  std::vector<Vec3> position;    ///< centres [m]
  std::vector<double> radius;    ///< [m], one for each centre
  std::vector<Contact> contacts; ///< between grains: those of coordination numbers, fabric and forces
  /// Of grain i with wall j; everything points from the centre to the wall, the branch ends at the foot of
  /// the perpendicular, the overlap is R_i - |branch|. They contribute to stress and stiffness and support
  /// grains.
  std::vector<Contact> wall_contacts = {};
  /// Of each grain, the rigid body (clump) that it is a part of, numbered from 0 without gaps; empty where
  /// each grain is a separate body. Contacts inside of a body carry no force.
  std::vector<std::uint32_t> body = {};

  [[nodiscard]] std::size_t grain_count() const { return position.size(); }
  /// Volume of the cell [m^3].
  [[nodiscard]] double volume() const { return determinant(cell); }

  bool operator==(const Assembly&) const = default;
};

/// Distances between the opposite faces of a cell [m].
/// Assumes   a positive volume.
[[nodiscard]] Vec3 cell_widths(const Mat3& cell);

/// Checks that the value is valid for the analyses: sizes agree, cell volume > 0, radii > 0,
/// indices in range and i < j (of walls i alone), branches and stiffnesses finite, forces finite.
/// \throws   InvalidArgument naming the first grain or contact that is not.
void require_valid(const Assembly& assembly);

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

/// Volume of the grains over that of the cell, (1/V) sum (4/3) pi R^3.
/// Assumes   spheres, of one radius or many; the small lenses shared by overlapping grains count twice.
/// \return   solid fraction [1]; 0 without grains
/// \throws   InvalidArgument for an assembly that require_valid rejects
/// Checked by tests/packing/test_density.cpp
[[nodiscard]] double solid_fraction(const Assembly& assembly);

/// e = V/(sum (4/3) pi R^3) - 1 [1]; assumptions of solid_fraction.
/// \throws   InvalidArgument also for an assembly without grains: the ratio has no value
/// Checked by tests/packing/test_density.cpp
[[nodiscard]] double void_ratio(const Assembly& assembly);

/// Unbalanced contact forces on grains at rest under a body force: the same force per volume on
/// each.
struct Weight {
  Vec3 per_volume{};    ///< density times gravity, along gravity [N/m3]
  double left_over = 1; ///< mean |residual force| without it over that with it, grains with a contact [1]
};

/// The common body force of all grains with a contact, by least squares of the residual forces on the
/// volumes.
/// \return   left_over = 1 where there is no residual
/// \throws   InvalidArgument for an assembly that require_valid rejects
/// Accuracy  rounding, where grains rest under such a force.  Checked by tests/packing/test_weight.cpp
[[nodiscard]] Weight common_weight(const Assembly& assembly);

} // namespace granum::packing
