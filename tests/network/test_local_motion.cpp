// SPDX-License-Identifier: GPL-3.0-or-later
#include <numeric>

#include <granum/network/linear_response.hpp>

#include "large_networks.hpp"
#include "network/block_cg.hpp"
#include "network/contact_operator.hpp"
#include "network/factor/local_motion.hpp"
#include "unit.hpp"

namespace {

/// A sample network, every third of whose grains also touches a wall.
packing::Assembly network_at_walls() {
  packing::Assembly a = samples::large_network(6, 0.4);
  for (std::uint32_t g = 0; g < a.grain_count(); g += 3) {
    packing::Contact c{.i = g, .j = 2, .branch = {0.5, 0, 0}, .tangential_force = {}};
    c.normal_stiffness = 1.5;
    c.tangential_stiffness = 0.7;
    a.wall_contacts.push_back(c);
  }
  return a;
}

/// x^T H x of six random motions of the grains given: by the contacts of these grains, and by all of H.
template <int Dof>
void check_energy(const packing::Assembly& a, const std::vector<std::uint32_t>& grains) {
  const network::Backbone backbone = network::load_bearing_network(a, {});
  REQUIRE(backbone.rotations == (Dof == 6));
  const network::LinksOfGrains links(backbone);
  const network::Workers alone;
  std::vector<std::uint32_t> place(backbone.grain_count, network::LocalMotion<Dof>::absent);
  samples::Uniform uniform(7);
  network::Field<Dof> x(backbone.grain_count), answer;
  {
    network::LocalMotion<Dof> motion(place);
    for (const std::uint32_t g : grains) {
      for (auto& row : x[g].row)
        for (int c = 0; c < network::load_cases; ++c)
          row[c] = uniform(-1, 1);
      motion.of(g) = x[g];
    }
    const network::PerCase energy = motion.energy(backbone, links), squares = motion.squares();
    network::apply_stiffness<Dof>(backbone, alone, 0, x, answer);
    const elastic::Matrix6 expected = network::products<Dof>(alone, x, answer);
    const elastic::Matrix6 sizes = network::products<Dof>(alone, x, x);
    for (int c = 0; c < network::load_cases; ++c) {
      CHECK(squares[static_cast<std::size_t>(c)] == doctest::Approx(sizes(c, c)).epsilon(1e-13));
      CHECK(energy[static_cast<std::size_t>(c)] == doctest::Approx(expected(c, c)).epsilon(1e-13));
    }
  }
  CHECK(std::count(place.begin(), place.end(), network::LocalMotion<Dof>::absent) ==
        static_cast<std::ptrdiff_t>(place.size()));
}

} // namespace

TEST_CASE("the energy of a motion of few grains is that of the whole network") {
  const std::vector<std::uint32_t> scattered{12, 3, 150}, cluster{60, 61, 62, 63, 64, 90, 91, 40, 41};
  std::vector<std::uint32_t> many(120);
  std::iota(many.begin(), many.end(), 0U);
  for (const auto& grains : {scattered, cluster, many, std::vector<std::uint32_t>{}}) {
    CAPTURE(grains.size());
    check_energy<6>(samples::large_network(6, 0.4), grains);
    check_energy<3>(samples::large_network(6, 0.6, 0), grains);
    check_energy<6>(network_at_walls(), grains);
  }
}
