// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/network.
#pragma once

#include <cstdint>
#include <vector>

#include <granum/packing/assembly.hpp>

namespace granum::network {

/// Neighbouring grains with successive numbers.
struct Piece {
  std::uint32_t first = 0, last = 0;
};

/// New numbers of the grains that bear load. Large networks are halved again and again, by a layer of grains
/// that goes between the halves and comes after both: pieces of one stage have no contact with each other and
/// no neighbour in common but in later stages, so that threads can work on them side by side. Inside of a
/// piece, neighbours are close in memory (reverse Cuthill-McKee), but grains that are barely held come first
/// and never go between halves: eliminated before their neighbours, they lose nothing by what an incomplete
/// factor drops.
struct Numbering {
  std::vector<std::uint32_t> number; ///< of each grain; `unset` for rattlers
  std::vector<std::vector<Piece>> stages;

  static constexpr std::uint32_t unset = ~std::uint32_t{0};
};

/// \param    position   inside the cell [m]
/// \param    soft       of each grain that bears load, whether it counts as barely held in any case; or empty
[[nodiscard]] Numbering number_grains(const packing::Assembly& assembly, const std::vector<bool>& rattler,
                                      const std::vector<Vec3>& position, const std::vector<bool>& soft);

} // namespace granum::network
