// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/network.
#pragma once

#include <cstdint>
#include <vector>

namespace granum::network {

/// Of every grain that bears load, those that it touches; none of other grains.
using Neighbours = std::vector<std::vector<std::uint32_t>>;

/// Grains that may move with hardly any resistance. One with two contacts is a bar between two joints: it
/// only resists a change of the distance between these. A contact is a joint, which resists three motions,
/// but one with a bar resists a single one, and a grain with seven such resistances in place of its six
/// motions may be free: two joints and a bar let it turn about the axis through the joints where the line of
/// the bar meets this axis, and balance of the three forces on the grain sees to that. Contacts with walls do
/// not count. Others are known by their motions alone (network/factor/soft_first.hpp).
class BarelyHeld {
 public:
  /// \param    soft   of each grain, whether it counts as barely held in any case; or empty
  explicit BarelyHeld(const Neighbours& neighbours, const std::vector<bool>& soft = {});

  [[nodiscard]] bool contains(std::uint32_t g) const { return first_[g] != none; }
  /// Of the grains that hang together with g, if g is barely held; else g itself.
  [[nodiscard]] std::uint32_t first_of_cluster(std::uint32_t g) const { return contains(g) ? first_[g] : g; }

 private:
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  std::vector<std::uint32_t> first_; ///< `none` where a grain is well held
};

} // namespace granum::network
