// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/network.
#pragma once

#include <vector>

#include "backbone.hpp"

namespace granum::network {

/// How an incomplete factor is made.
struct FactorRule {
  int fill_level = 1;
  double shift = 1e-6; ///< added to the diagonal over its mean, for spins that nothing resists: a grain with
                       ///< two contacts turns freely about them
  /// What becomes of a direction in which a pivot is not safely positive. true: it is held while the others
  /// are eliminated, so that it cannot spoil those behind it. false: it gets a small stiffness at once.
  bool holds_lost = true;

  bool operator==(const FactorRule&) const = default;
};

/// The rule that suits the network, and behind it others, to be tried in turn where it fails. Pivots are lost
/// by what the factor drops, and no rule loses few in every network.
[[nodiscard]] std::vector<FactorRule> factor_rules(const Backbone& backbone);

} // namespace granum::network
