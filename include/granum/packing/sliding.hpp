// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include <granum/packing/assembly.hpp>

/// Which contacts are at the Coulomb limit, from their forces: files of DEM codes contain no such flag.
/// Contacts with small forces (f_n below 1e-3 of the mean) are left out: their forces are seldom at rest.
/// Checked by tests/packing/test_sliding.cpp
namespace granum::packing {

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
