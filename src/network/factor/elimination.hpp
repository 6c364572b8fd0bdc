// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/network.
#pragma once

#include <cstddef>
#include <vector>

#include "factor_rule.hpp"
#include "network/backbone.hpp"
#include "network/lanes.hpp"
#include "network/workers.hpp"

namespace granum::network {

/// An incomplete factor R^T H R ~ L L^T; symbols in elimination.cpp.
template <int Dof>
struct Eliminated {
  std::vector<Block<Dof>> root = {}; ///< R of each grain
  /// Strictly lower blocks of L, each transposed, by pieces; pieces are numbered through all stages.
  std::vector<std::vector<Block<Dof>>> lower = {};
  std::size_t mended_pivots = 0; ///< pivots that were modified
  /// With SoftPivots::by_motion or coupled: grains of lost motions, and of very soft ones; may repeat.
  std::vector<std::uint32_t> lost_grains = {}, soft_grains = {};
};

/// Eliminates grain after grain, in double precision: the terms that couple a soft motion with its
/// neighbours cancel to 1e-6.
/// \param    pattern   of the blocks that are kept
template <int Dof>
[[nodiscard]] Eliminated<Dof> eliminate(const Backbone& backbone, const Workers& workers,
                                        const FactorRule& rule, const FillPattern& pattern);

} // namespace granum::network
