// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <granum/packing/assembly.hpp>

namespace granum::packing {

/// C_n = 2 N_c/N over all grains, rattlers included.                                        [Chung2014]
/// Assumes   every listed contact between grains counts, whatever force it carries; those with walls do not.
/// \return   C_n [1]; 0 for grains without contacts
/// \throws   InvalidArgument for an assembly without grains: the ratio has no value
/// Checked by tests/packing/test_coordination.cpp
[[nodiscard]] double coordination_number(const Assembly& assembly);

/// Kind of contact: it determines the least number of contacts, walls included, that can support a grain.
enum class ContactKind {
  frictional,  ///< normal and tangential force: a grain needs 2 contacts
  frictionless ///< normal force only: a grain needs 4 contacts
};

/// The load-bearing part of an assembly.
struct MechanicalCoordination {
  std::vector<bool> rattler; ///< one flag for each grain
  std::size_t rattler_count = 0;
  std::size_t contact_count = 0;      ///< N_c*, contacts between grains that are not rattlers
  std::size_t wall_contact_count = 0; ///< of such grains with walls
  double rattler_fraction = 0;        ///< x_0 = rattlers / grains [1]; 0 without grains
  double coordination_number = 0;     ///< z* = 2 N_c*/N* [1]; 0 when every grain is a rattler
};

/// z* and rattlers: grains with too few contacts are removed iteratively, until none is left.
///                                                                                        [AgnolinRoux2007a]
/// Assumes   kind is that of the contacts in the probe, not of the preparation.
/// \param    kind   frictional: fewer than 2 contacts make a rattler; frictionless: fewer than 4
/// \throws   InvalidArgument for an assembly that require_valid rejects
/// Checked by tests/packing/test_coordination.cpp
[[nodiscard]] MechanicalCoordination mechanical_coordination(const Assembly& assembly, ContactKind kind);

/// Unit normals of all contacts, from i to j, in the order of the contacts.
/// \throws   InvalidArgument for an assembly that require_valid rejects
/// Checked by tests/packing/test_fabric_tensor.cpp
[[nodiscard]] std::vector<Vec3> contact_normals(const Assembly& assembly);

/// F_ij = mean of n_i n_j over all contacts; trace 1.                                          [Satake1982]
/// Assumes   every listed contact counts once, whatever force it carries.
/// \throws   InvalidArgument for an assembly without contacts: the mean has no value
/// Accuracy  rounding.  Checked by tests/packing/test_fabric_tensor.cpp
[[nodiscard]] Mat3 fabric_tensor(const Assembly& assembly);
/// The same of normals alone.
[[nodiscard]] Mat3 fabric_tensor(std::span<const Vec3> normals);

/// \file
/// Which contacts are at the Coulomb limit, from their forces: files of DEM codes contain no such flag.
/// Contacts with small forces (f_n below 1e-3 of the mean) are left out: their forces are seldom at rest.
/// Checked by tests/packing/test_sliding.cpp

/// The Coulomb limit as the forces show it.
struct FrictionEstimate {
  double coefficient = 0;   ///< mu [1]
  std::size_t contacts = 0; ///< at the limit, within 1e-4 relative
};

/// The friction coefficient at which contacts pile up: the ratio f_t/f_n within whose last 1e-4 there are at
/// least 5 contacts, and ten times as many as a smooth distribution would have. Up to one contact in a
/// thousand may lie above it.
/// \return   empty if there is no accumulation of contacts at a ratio
/// \throws   InvalidArgument for an assembly that require_valid rejects
/// Accuracy  1e-4 relative.
[[nodiscard]] std::optional<FrictionEstimate> estimate_friction(const Assembly& assembly);

/// Share of the contacts that slide, f_t >= (1 - 1e-3) mu f_n.
/// \param    friction_coefficient   mu >= 0 [1]; where it is 0, no contact slides
/// \return   sliding over pressing contacts [1]; 0 if none presses
/// \throws   InvalidArgument for an assembly that require_valid rejects, or a coefficient out of range
[[nodiscard]] double sliding_fraction(const Assembly& assembly, double friction_coefficient);

/// Share of the contacts that the engine has found at the Coulomb limit (Contact::sliding).
/// \return   sliding over all contacts [1]; 0 without contacts
[[nodiscard]] double sliding_fraction(const Assembly& assembly);

} // namespace granum::packing
