// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/numbering/numbering.hpp"

#include "large_networks.hpp"
#include "network/backbone.hpp"
#include "unit.hpp"

namespace {

network::Neighbours neighbours_of(const network::Backbone& backbone) {
  network::Neighbours neighbours(backbone.grain_count);
  for (const network::Link& l : backbone.links) {
    neighbours[l.a].push_back(l.b);
    neighbours[l.b].push_back(l.a);
  }
  return neighbours;
}

} // namespace

namespace {

/// In each piece of the first stage.
template <class IsFirst>
std::size_t out_of_order(const network::Backbone& backbone, const IsFirst& is_first) {
  std::size_t count = 0;
  for (const network::Piece& p : backbone.stages.front())
    for (std::uint32_t g = p.first; g + 1 < p.last; ++g)
      count += !is_first(g) && is_first(g + 1) ? 1U : 0U;
  return count;
}

} // namespace

TEST_CASE("weakly supported grains come first in pieces of the first stage, whole clusters in one") {
  const network::Backbone backbone = network::load_bearing_network(samples::large_network(29, 0.26), {});
  REQUIRE(backbone.stages.size() == 3);
  const network::WeaklySupported weakly_supported(neighbours_of(backbone));
  CHECK(out_of_order(backbone, [&](std::uint32_t g) { return weakly_supported.contains(g); }) == 0);
  std::vector<std::size_t> piece(backbone.grain_count, 0); // 0: of a later stage
  std::size_t pieces = 0, barely = 0, elsewhere = 0, split = 0;
  for (const network::Piece& p : backbone.stages.front())
    std::fill(piece.begin() + p.first, piece.begin() + p.last, ++pieces);
  for (std::uint32_t g = 0; g < backbone.grain_count; ++g)
    if (weakly_supported.contains(g)) {
      ++barely;
      elsewhere += piece[g] == 0 ? 1U : 0U;
      split += piece[g] != piece[weakly_supported.first_of_cluster(g)] ? 1U : 0U;
    }
  CHECK(barely > 1000);
  CHECK(elsewhere == 0);
  CHECK(split == 0);
}

TEST_CASE("grains that count as weakly supported come first in pieces of the first stage") {
  const packing::Assembly a = samples::large_network(28, 0.3);
  std::vector<bool> soft(a.grain_count());
  for (std::uint32_t g = 0; g < a.grain_count(); g += 40)
    soft[g] = true;
  const network::Backbone backbone = network::load_bearing_network(a, {}, soft);
  const network::WeaklySupported by_contacts(neighbours_of(backbone));
  const auto is_soft = [&](std::uint32_t g) { return soft[backbone.grain[g]]; };
  CHECK(out_of_order(backbone, [&](std::uint32_t g) { return by_contacts.contains(g) || is_soft(g); }) == 0);
  std::size_t numbered = 0, in_first_stage = 0;
  for (std::uint32_t g = 0; g < backbone.grain_count; ++g)
    numbered += is_soft(g) ? 1U : 0U;
  for (const network::Piece& p : backbone.stages.front())
    for (std::uint32_t g = p.first; g < p.last; ++g)
      in_first_stage += is_soft(g) ? 1U : 0U;
  CHECK(in_first_stage == numbered);
  CHECK(in_first_stage > 400);
}
