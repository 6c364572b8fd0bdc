// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/network. Storage of the six load cases side by side, so that one pass over the contacts
// serves all.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/vector/level.hpp"

namespace granum::network {

inline constexpr int load_cases = 6;

/// One number of every load case; lanes 6 and 7 stay zero.
using Lanes = Eight;

/// One number of every load case, outside of passes over grains.
using PerCase = std::array<double, std::size_t{load_cases}>;

/// Degrees of freedom of one grain (rows) for every load case (lanes).
template <int Dof>
struct alignas(64) Rows {
  Lanes row[std::size_t{Dof}] = {};
};

/// A vector over all grains, for every load case.
template <int Dof>
using Field = std::vector<Rows<Dof>>;

/// Coupling of two grains, or of one with itself.
template <int Dof, class Number = double>
struct Block {
  Number at[std::size_t{Dof}][std::size_t{Dof}] = {};
};

template <int Dof>
void add(const Block<Dof>& from, Block<Dof>& to) {
  for (int r = 0; r < Dof; ++r)
    for (int c = 0; c < Dof; ++c)
      to.at[r][c] += from.at[r][c];
}

/// 6 x 6 products of two fields.
struct alignas(64) Gram {
  Lanes row[load_cases] = {};
};

} // namespace granum::network
