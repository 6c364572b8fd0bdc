// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/network.
#pragma once

#include <cstdint>
#include <vector>

#include "network/backbone.hpp"

namespace granum::network {

/// Places of the strictly lower blocks of an incomplete factor, by rows.
struct FillPattern {
  std::vector<std::uint32_t> row_start;
  std::vector<std::uint32_t> column; ///< rising in each row

  [[nodiscard]] std::size_t size() const { return column.size(); }
};

/// A contact has level 0. Two grains that an earlier grain couples have the levels of its two couplings and 1
/// more, of all such grains the least; what has a higher level than `most_level` is dropped.
[[nodiscard]] FillPattern fill_pattern(const Backbone& backbone, int most_level);

/// Of the highest level, or of the highest below it that keeps the factor within `most_blocks` a grain; of
/// level 1 in any case.
[[nodiscard]] FillPattern fill_pattern_within(const Backbone& backbone, int highest_level,
                                              double most_blocks);

} // namespace granum::network
