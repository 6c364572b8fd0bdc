// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/dem.
#pragma once

#include <vector>

#include <granum/contact/power_law.hpp>
#include <granum/core/vec3.hpp>
#include <granum/dem/neighbours.hpp>

#include "grain_rows.hpp"
#include "wall_contacts.hpp"

namespace granum::dem {

struct FrequencyInput {
  const std::vector<Pair>& pairs;
  const Grains& grains;
  Mat3 cell;
  double radius;           ///< where all grains are equal [m]
  double tangential_ratio; ///< k_t/k_n; 0 without friction
  double mass;             ///< likewise [kg]
  double inertia;          ///< likewise [kg m^2]
};

/// Strict bound on omega^2 of the highest frequency [1/s^2]; 0 where nothing touches. A contact couples two
/// grains, so the stiffness matrix is at most twice its block diagonal; the block of a grain is at most the
/// sum over its contacts of k_n nn + k_t (1 - nn) (translation) and k_t R^2 (1 - nn) (rotation: its lever is
/// R at most), bounded here by row sums of these matrices. A wall does not move with its grain: its contacts
/// count half.
/// \param    walls   null: none
[[nodiscard]] double highest_frequency_squared(const contact::NormalKernel& law, const FrequencyInput& input,
                                               const WallContacts* walls);

} // namespace granum::dem
