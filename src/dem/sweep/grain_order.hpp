// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/dem. Order of the grains in an engine: neighbours are near in memory, for the caches. An
// order gives the new index of each grain.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <granum/dem/specimen.hpp>

namespace granum::dem {

/// Along a space-filling curve through the cell.
[[nodiscard]] std::vector<std::uint32_t> near_order(const Specimen& state);
[[nodiscard]] std::vector<std::uint32_t> inverse_order(const std::vector<std::uint32_t>& order);
/// Whether this is a permutation of `count` grains.
[[nodiscard]] bool is_order(const std::vector<std::uint32_t>& order, std::size_t count);

/// The same state with its grains in another order; contact memories are reversed where i and j are
/// exchanged.
[[nodiscard]] Specimen reordered(const Specimen& state, const std::vector<std::uint32_t>& order);

} // namespace granum::dem
