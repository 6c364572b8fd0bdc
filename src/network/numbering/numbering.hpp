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

/// Order of elimination of the grains that carry load. Large networks are halved repeatedly (nested
/// dissection); the layer of grains between two halves comes after both. Pieces of one stage have no contact
/// with each other, and share neighbours in later stages only, so threads can process them at the same time.
/// Within a piece, neighbours are close in memory (reverse Cuthill-McKee). Weakly supported grains come first
/// in their piece and are never in a layer: when they are eliminated before their neighbours, an incomplete
/// factor drops none of their terms.
struct Numbering {
  std::vector<std::uint32_t> number; ///< of each grain; `unset` for rattlers
  std::vector<std::vector<Piece>> stages;

  static constexpr std::uint32_t unset = ~std::uint32_t{0};
};

/// \param    position   inside the cell [m]
/// \param    soft       for each grain: treat it as weakly supported; or empty
[[nodiscard]] Numbering number_grains(const packing::Assembly& assembly, const std::vector<bool>& rattler,
                                      const std::vector<Vec3>& position, const std::vector<bool>& soft);

} // namespace granum::network
