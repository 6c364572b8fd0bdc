// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/dem.
#pragma once

#include <cstdint>

namespace granum::dem {

/// FIRE's rule for the turn of velocities towards the forces in a step, as published.    [Bitzek2006]
struct FireMixing {
  double share = first_share;
  std::uint64_t downhill_steps = 0; ///< counted up to the patience of the rule

  static constexpr double first_share = 0.1;
  static constexpr std::uint64_t patience = 5;

  /// A step with positive work of the forces. True after many of them.
  bool downhill() {
    if (downhill_steps < patience) {
      ++downhill_steps;
      return false;
    }
    share *= 0.99;
    return true;
  }
  /// A step without: restarts the rule.
  void uphill() { *this = {}; }
};

} // namespace granum::dem
