// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/network.
#pragma once

#include <cstdint>
#include <vector>

#include "network/backbone.hpp"

namespace granum::network {

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

} // namespace granum::network
