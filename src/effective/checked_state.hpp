// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/core/error.hpp>

#include "kernels.hpp"

namespace granum::effective::kernel {

/// k_t/k_n beyond which no estimate is given.
inline constexpr double largest_tangential_ratio = 100;

/// A state that has passed require_valid, and the derived numbers that every estimate needs.
struct CheckedState {
  Geometry<double> geometry;
  NormalLoads<double> loads; ///< of the static field
  double stiffness = 0;      ///< k_n at the geometric mean of the loads, 0 without contacts [N/m]
  Validity validity;
};

/// \throws   InvalidArgument as require_valid
CheckedState checked(const State& state);

/// The geometry only, for callers that need neither k_n nor notes.
/// \throws   InvalidArgument as require_valid
Geometry<double> checked_geometry(const State& state);

/// Refuses a state without contacts, which cannot carry a force.
/// \throws   InvalidArgument if C_n = 0
void require_contacts(const State& state);

} // namespace granum::effective::kernel
