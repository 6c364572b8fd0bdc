// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/network.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vector/level.hpp"
#include "network/backbone.hpp"

namespace granum::network {

/// Equal boxes that fill the cell, each with its grains and a node at each of its eight corners, as many
/// nodes as boxes because the cell is periodic. Along an axis with one box only, both corners are the same
/// node.
class CoarseGrid {
 public:
  using Corners =
      std::array<std::uint32_t, 8>; ///< corner c is at the far end of axis k where bit k of c is set
  using Shares = std::array<double, 8>;

  /// \param    grains_a_box   on average, about
  CoarseGrid(const Backbone& backbone, double grains_a_box);

  /// Boxes, and nodes.
  [[nodiscard]] std::size_t size() const { return grains_start_.size() - 1; }
  [[nodiscard]] std::span<const std::uint32_t> grains_of(std::size_t box) const {
    return std::span(grains_).subspan(grains_start_[box], grains_start_[box + 1] - grains_start_[box]);
  }
  [[nodiscard]] std::uint32_t box_of(std::size_t grain) const { return box_[grain]; }
  [[nodiscard]] Corners nodes_of(std::size_t box) const { return neighbours(box, 1); }
  /// The boxes that have a node as their corner 0, 1, ...
  [[nodiscard]] Corners boxes_around(std::size_t node) const { return neighbours(node, -1); }
  /// Weights of the corners of its box for a grain: linear along each edge, with the sum 1.
  [[nodiscard]] GRANUM_INLINE Shares shares_of(std::size_t grain) const {
    const Vec3& far = part_[grain];
    const Vec3 near{1 - far.x, 1 - far.y, 1 - far.z};
    Shares share;
    for (unsigned c = 0; c < share.size(); ++c)
      share[c] = ((c & 1U) != 0 ? far.x : near.x) * ((c & 2U) != 0 ? far.y : near.y) *
                 ((c & 4U) != 0 ? far.z : near.z);
    return share;
  }

 private:
  [[nodiscard]] Corners neighbours(std::size_t number, int direction) const;

  std::array<std::size_t, 3> along_{}; ///< boxes
  std::vector<Vec3> part_;             ///< position of each grain in its box, components in [0, 1]
  std::vector<std::uint32_t> box_;     ///< of each grain
  std::vector<std::uint32_t> grains_;  ///< box after box
  std::vector<std::uint32_t> grains_start_;
};

} // namespace granum::network
