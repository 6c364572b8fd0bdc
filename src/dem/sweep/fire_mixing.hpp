// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/dem.
#pragma once

#include <cstdint>

namespace granum::dem {

/// FIRE's rule for how far velocities are turned towards the forces in a step, as published.    [Bitzek2006]
struct FireMixing {
  double share = first_share;
  std::uint64_t downhill_steps = 0; ///< no more of them are counted than patience asks for

  static constexpr double first_share = 0.1;
  static constexpr std::uint64_t patience = 5;

  /// A step in which the forces do work. True once it is one of many.
  bool downhill() {
    if (downhill_steps < patience) {
      ++downhill_steps;
      return false;
    }
    share *= 0.99;
    return true;
  }
  /// A step in which they do not: all starts again.
  void uphill() { *this = {}; }
};

} // namespace granum::dem
