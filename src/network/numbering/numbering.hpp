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

/// The neighbours of every grain that carries load; empty for other grains.
using Neighbours = std::vector<std::vector<std::uint32_t>>;

/// Grains that may move with hardly any resistance, found by counting contacts. A grain with two contacts is
/// a bar between two joints: it only resists a change of the distance between them. A contact resists three
/// motions, but a contact with a bar only one. A grain with at most seven resistances (it has six motions)
/// may move freely: with two contacts and a bar it can rotate about the axis through the two contacts if the
/// line of the bar meets this axis, and equilibrium of the three forces makes it do so. Contacts with walls
/// do not count. Other soft motions are found by their energy (network/factor/incomplete_factor.hpp).
class WeaklySupported {
 public:
  /// \param    soft   for each grain: count it as weakly supported in any case; or empty
  explicit WeaklySupported(const Neighbours& neighbours, const std::vector<bool>& soft = {});

  [[nodiscard]] bool contains(std::uint32_t g) const { return first_[g] != none; }
  /// First grain of the connected cluster of weakly supported grains around g; g itself if it is not one.
  [[nodiscard]] std::uint32_t first_of_cluster(std::uint32_t g) const { return contains(g) ? first_[g] : g; }

 private:
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  std::vector<std::uint32_t> first_; ///< `none` for other grains
};

} // namespace granum::network
