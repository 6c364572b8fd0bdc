// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <granum/contact/normal_law.hpp>
#include <granum/core/bytes.hpp>
#include <granum/core/vec3.hpp>
#include <granum/packing/assembly.hpp>

namespace granum::dem {

/// Material of the grains and law of their contacts.
struct Material {
  contact::NormalLaw law;          ///< normal contact of two grains of size 1 (Specimen::size)
  double tangential_ratio = 0;     ///< k_t/k_n >= 0 [1]
  double friction_coefficient = 0; ///< mu >= 0 [1]; infinity: no contact slides
  double density = 2650;           ///< of the grains [kg/m^3]; sets the time scale, no quasi-static result

  /// Whether contacts carry tangential forces; otherwise rotations and histories are left out.
  [[nodiscard]] bool tangential() const { return friction_coefficient > 0 && tangential_ratio > 0; }
};

/// All contact laws except cusps (alpha < 1, contact/power_law.hpp) can be simulated.
/// \throws InvalidArgument for a law that grains cannot be simulated with.
void require_simulable(const contact::NormalLaw& law);
/// \throws InvalidArgument for an impossible value, and as require_simulable.
void require_valid(const Material& material);

/// Memory of one contact, i < j.
struct ContactHistory {
  std::uint32_t i = 0;
  std::uint32_t j = 0;
  Vec3 tangential_force;           ///< exerted by i on j [N]
  double tangential_stiffness = 0; ///< at the last step [N/m]

  bool operator==(const ContactHistory&) const = default;
};

/// Memory of the contact of a grain with a wall.
struct WallHistory {
  std::uint32_t grain = 0;
  std::uint32_t wall = 0;          ///< as wall_planes numbers them
  Vec3 tangential_force;           ///< exerted on the grain [N]
  double tangential_stiffness = 0; ///< at the last step [N/m]

  bool operator==(const WallHistory&) const = default;
};

/// Six rigid plane walls, the faces of the cell.
struct Walls {
  double friction_coefficient = 0;  ///< mu >= 0 between grain and wall; 0: smooth, infinity: no slip [1]
  std::vector<WallHistory> history; ///< sorted by (grain, wall)

  bool operator==(const Walls&) const = default;
};

/// Complete state of a simulation of spheres. Contacts of unequal grains: contact/grains.hpp.
struct Specimen {
  Mat3 cell;                ///< columns are the edge vectors [m]
  double radius = 0;        ///< of a grain of size 1 [m]
  std::vector<double> size; ///< radius of each grain over `radius` [1]; empty: all grains have size 1
  std::vector<Vec3> position;
  std::vector<Vec3> velocity;          ///< beyond the affine motion of the cell [m/s]
  std::vector<Vec3> angular_velocity;  ///< [1/s]
  std::vector<ContactHistory> history; ///< sorted by (i, j)
  std::optional<Walls> walls;          ///< none: the cell is periodic

  [[nodiscard]] std::size_t grain_count() const { return position.size(); }
  /// Of one grain [m].
  [[nodiscard]] double radius_of(std::size_t grain) const {
    return size.empty() ? radius : radius * size[grain];
  }
  bool operator==(const Specimen&) const = default;
};

/// \throws InvalidArgument for an impossible value.
void require_valid(const Walls& walls);

/// \throws InvalidArgument unless there are no sizes, or one for each grain, positive and finite.
void require_valid_sizes(const Specimen& state);

/// Of its grains; 1 where all are equal.
[[nodiscard]] double largest_size(const Specimen& state);
[[nodiscard]] double smallest_size(const Specimen& state);

/// Sum of the volumes of the grains [m^3].
[[nodiscard]] double grain_volume(const Specimen& state);

/// void_ratio = cell volume / grain volume - 1; overlaps count once for each grain, as in the paper.
[[nodiscard]] double void_ratio(const Specimen& state);

/// All contacts between grains, and with walls, with forces and tangent stiffnesses from the material's law.
/// Smooth walls have no tangential stiffness.
[[nodiscard]] packing::Assembly contact_network(const Specimen& state, const Material& material);

/// \file
/// Six rigid plane walls, the faces of the cell, in place of periodicity. A wall moves with the centre of its
/// face and rotates with it, as a rigid plate; shear of the cell tilts a pair of opposite walls. A contact
/// with a rigid plane equals, by symmetry, half of the contact of a grain with its mirror image. With the
/// pair law f = F(d), a grain whose centre is R - d_w from the wall has f = F(2 d_w), k_n = 2 F'(2 d_w).
/// k_t/k_n is that of the grains. Rough walls carry a part of each other's stress by friction.
/// Checked by tests/dem/test_walls.cpp

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

/// Writes a specimen to the bit; load_specimen reads an equal one.
/// Checked by tests/dem/test_engine_bytes.cpp
void save_specimen(ByteWriter& to, const Specimen& state);
/// \throws   FileError if the bytes end early, or describe an invalid specimen: indices of missing grains,
///           cells without volume, NaN
[[nodiscard]] Specimen load_specimen(ByteReader& from);

} // namespace granum::dem
