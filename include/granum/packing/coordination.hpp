// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
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

} // namespace granum::packing
