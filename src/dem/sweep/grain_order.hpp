// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/dem. The order in which an engine holds its grains: neighbours near each other, so that what
// a pair needs is in the caches. An order gives the new place of each grain.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <granum/dem/specimen.hpp>

namespace granum::dem {

/// Along a space-filling curve through the cell.
[[nodiscard]] std::vector<std::uint32_t> near_order(const Specimen& state);
[[nodiscard]] std::vector<std::uint32_t> inverse_order(const std::vector<std::uint32_t>& order);
/// Whether it is an order of `count` grains.
[[nodiscard]] bool is_order(const std::vector<std::uint32_t>& order, std::size_t count);

/// The same state with its grains in another order; memories turn round where their grains change sides.
[[nodiscard]] Specimen reordered(const Specimen& state, const std::vector<std::uint32_t>& order);

} // namespace granum::dem
