// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/numbering/numbering.hpp"

#include "large_networks.hpp"
#include "network/backbone.hpp"
#include "unit.hpp"

TEST_CASE("weakly supported grains come first in pieces of the first stage, whole clusters in one") {
  const packing::Assembly a = samples::large_network(29, 0.26);
  std::vector<bool> given(a.grain_count()); // to count as such in any case
  for (std::uint32_t g = 0; g < a.grain_count(); g += 40)
    given[g] = true;
  const network::Backbone backbone = network::load_bearing_network(a, {}, given);
  REQUIRE(backbone.stages.size() == 3);
  network::Neighbours neighbours(backbone.grain_count);
  for (const network::Link& l : backbone.links) {
    neighbours[l.a].push_back(l.b);
    neighbours[l.b].push_back(l.a);
  }
  std::vector<bool> soft;
  for (const std::uint32_t g : backbone.grain)
    soft.push_back(given[g]);
  const network::WeaklySupported weakly_supported(neighbours, soft), by_contacts(neighbours);
  std::vector<std::size_t> piece(backbone.grain_count, 0); // 0: of a later stage
  std::size_t pieces = 0, out_of_order = 0, few_contacts = 0, elsewhere = 0, split = 0;
  for (const network::Piece& p : backbone.stages.front()) {
    std::fill(piece.begin() + p.first, piece.begin() + p.last, ++pieces);
    for (std::uint32_t g = p.first; g + 1 < p.last; ++g)
      out_of_order += !weakly_supported.contains(g) && weakly_supported.contains(g + 1) ? 1U : 0U;
  }
  for (std::uint32_t g = 0; g < backbone.grain_count; ++g)
    if (weakly_supported.contains(g)) {
      few_contacts += by_contacts.contains(g) ? 1U : 0U;
      elsewhere += piece[g] == 0 ? 1U : 0U;
      split += piece[g] != piece[weakly_supported.first_of_cluster(g)] ? 1U : 0U;
    }
  CHECK(few_contacts > 1000);
  CHECK(out_of_order == 0);
  CHECK(elsewhere == 0);
  CHECK(split == 0);
}

TEST_CASE("three contacts, one to a bar, support a grain weakly, and three to others well") {
  network::Neighbours neighbours(8); // 3 to 7 touch one another
  const auto join = [&](std::uint32_t g, std::uint32_t h) {
    neighbours[g].push_back(h);
    neighbours[h].push_back(g);
  };
  for (std::uint32_t g = 3; g < 8; ++g)
    for (std::uint32_t h = 3; h < g; ++h)
      join(g, h);
  join(0, 1), join(0, 3), join(1, 4), join(1, 5); // 0 is a bar
  join(2, 5), join(2, 6), join(2, 7);
  const network::WeaklySupported weakly_supported(neighbours);
  for (std::uint32_t g = 0; g < 8; ++g) {
    CHECK(weakly_supported.contains(g) == (g < 2));
    CHECK(weakly_supported.first_of_cluster(g) == (g == 1 ? 0 : g));
  }
}
