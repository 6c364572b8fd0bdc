// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/network.
#pragma once

#include <cstddef>
#include <vector>

#include "factor_rule.hpp"
#include "fill_pattern.hpp"
#include "network/backbone.hpp"
#include "network/lanes.hpp"
#include "network/workers.hpp"

namespace granum::network {

/// An incomplete factor R^T H R ~ L L^T with the roots R of the inverse pivots, R R^T = pivot^-1, and with L
/// that has unit blocks on its diagonal.
template <int Dof>
struct Eliminated {
  std::vector<Block<Dof>> root = {}; ///< R of each grain
  /// Strictly lower blocks of each piece, pieces counted through all stages; each is transposed.
  std::vector<std::vector<Block<Dof>>> lower = {};
  std::size_t mended_pivots = 0;
  /// Where pivots are judged: the grains that take part in motions whose pivots were lost, and in very soft
  /// ones. Some more than once.
  std::vector<std::uint32_t> lost_grains = {}, soft_grains = {};
};

/// Eliminates grain after grain, in double precision: where grains are barely held, the coupling of a soft
/// motion with its neighbours is what is left of terms that cancel to 1e-6.
/// \param    pattern   of the blocks that are kept
template <int Dof>
[[nodiscard]] Eliminated<Dof> eliminate(const Backbone& backbone, const Workers& workers,
                                        const FactorRule& rule, const FillPattern& pattern);

} // namespace granum::network
