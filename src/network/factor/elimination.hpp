// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/network. What an incomplete factor keeps, how it treats soft pivots, and its elimination.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "network/backbone.hpp"
#include "network/lanes.hpp"

namespace granum::network {

/// How a soft or negative pivot direction is treated: it may be a genuinely soft motion, or an artefact of
/// dropped fill. Energies and motions of directions: elimination.cpp.
enum class SoftPivots {
  stiffened, ///< gets a small stiffness at once
  /// If it is not safely positive, it is rigid during the elimination, so that it cannot spoil later pivots,
  /// and gets the energy of its motion afterwards.
  deferred,
  /// Gets the energy of its motion at once. If this differs much from the pivot's stiffness, it is deferred;
  /// if it is zero, the direction stays rigid. Takes longer.
  by_motion,
  /// As by_motion, but its coupling with later grains consists of the forces of the motion, not of what the
  /// elimination leaves; and only directions with a wrong stiffness are deferred, not others of that pivot.
  coupled
};

[[nodiscard]] constexpr bool uses_motions(SoftPivots soft) {
  return soft == SoftPivots::by_motion || soft == SoftPivots::coupled;
}

/// How an incomplete factor is made.
struct FactorRule {
  int fill_level = 1;
  /// Over the mean diagonal. Added to the diagonal, for motions without resistance, such as the rotation of a
  /// grain about the line through its two contacts. With uses_motions, energies below it count as zero.
  double shift = 1e-6;
  SoftPivots soft_pivots = SoftPivots::deferred;

  bool operator==(const FactorRule&) const = default;
};

/// Factor rules in the order to try: the one chosen for this network, then fallbacks. Dropped fill makes any
/// rule fail in some networks.
[[nodiscard]] std::vector<FactorRule> factor_rules(const Backbone& backbone);

/// Positions of the strictly lower blocks of an incomplete factor, by rows.
struct FillPattern {
  std::vector<std::uint32_t> row_start;
  std::vector<std::uint32_t> column; ///< ascending in each row

  [[nodiscard]] std::size_t size() const { return column.size(); }
};

/// Blocks up to a level of fill. A contact has level 0. Two grains that share an earlier grain have the sum
/// of the levels of their couplings with it plus 1; the least value over all such grains counts.
[[nodiscard]] FillPattern fill_pattern(const Backbone& backbone, int most_level);

/// With the highest level up to `highest_level` that keeps the factor within `most_blocks` a grain; level 1
/// in any case.
[[nodiscard]] FillPattern fill_pattern_within(const Backbone& backbone, int highest_level,
                                              double most_blocks);

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
