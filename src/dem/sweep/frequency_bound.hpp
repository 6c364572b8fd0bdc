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
  std::size_t contacts;    ///< of the pairs, about: what to make room for
};

/// Strict bound on omega^2 of the highest frequency [1/s^2]; 0 where nothing touches. A contact couples two
/// grains, so the stiffness matrix is at most a block diagonal in which each contact counts 1 + w_j/w_i times
/// for grain i, with any w > 0, and is the closer to it the more w is like the fastest mode's amplitudes: w
/// from the stiffness that holds each grain, and that times the bound it gives, the better of two. 1.1 to 1.3
/// times the highest frequency squared of packings at rest.
/// Assumes   a rotational inertia of m R^2.
/// \param    walls   null: none
/// Checked by tests/dem/test_frequency_bound.cpp
[[nodiscard]] double highest_frequency_squared(const contact::NormalKernel& law, const FrequencyInput& input,
                                               const WallContacts* walls);

} // namespace granum::dem
