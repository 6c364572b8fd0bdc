// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/network.
#pragma once

#include <vector>

#include "network/backbone.hpp"

namespace granum::network {

/// What becomes of a direction d in which a pivot is soft or negative. Some motions of a packing are soft; of
/// others the stiffness was lost with what the factor drops.
enum class SoftPivots {
  /// It gets a small stiffness at once.
  stiffened,
  /// Where it is not positive, it is held while the others are eliminated, so that it cannot spoil those
  /// behind it, and gets the stiffness v^T H v of the motion v that it stands for afterwards.
  held,
  /// It gets v^T H v at once. Where that is far from the pivot's own stiffness, it is held; where it is
  /// nothing, it stays rigid. Takes longer.
  judged,
  /// The same, but the forces H v on later grains couple it with them, not what the elimination leaves, and
  /// only directions whose stiffness is far off are held, not the others of their pivot.
  coupled
};

[[nodiscard]] constexpr bool judges(SoftPivots soft) {
  return soft == SoftPivots::judged || soft == SoftPivots::coupled;
}

/// How an incomplete factor is made.
struct FactorRule {
  int fill_level = 1;
  /// Over the mean diagonal. Added to the diagonal, for motions that nothing resists, as a grain with two
  /// contacts turns freely about them; where pivots are judged, motions that are softer are free.
  double shift = 1e-6;
  SoftPivots soft_pivots = SoftPivots::held;

  bool operator==(const FactorRule&) const = default;
};

/// The rule that suits the network, and behind it others, to be tried in turn where it fails. Pivots are lost
/// by what the factor drops, and no rule loses few in every network.
[[nodiscard]] std::vector<FactorRule> factor_rules(const Backbone& backbone);

} // namespace granum::network
