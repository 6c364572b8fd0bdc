// SPDX-License-Identifier: GPL-3.0-or-later
// Large diluted lattices in which the factor loses pivots.
#include "network/factor/incomplete_factor.hpp"

#include "large_networks.hpp"
#include "unit.hpp"

using namespace granum::network;

namespace {

const Workers one_worker;

/// The numbers of the assembly's grains that each contact joins.
std::vector<std::pair<std::uint32_t, std::uint32_t>> joined(const Backbone& backbone) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (const Link& l : backbone.links)
    pairs.push_back(std::minmax(backbone.grain[l.a], backbone.grain[l.b]));
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

} // namespace

TEST_CASE("with the grains of soft motions first the factor loses no pivot") {
  const packing::Assembly a = samples::large_network(28, 0.235 + 0.045 * 10 / 11, 1, 5010);
  Backbone backbone = load_bearing_network(a, {});
  const FactorRule rule = factor_rules(backbone).front();
  REQUIRE(uses_motions(rule.soft_pivots));
  const IncompleteFactor<6> plain(backbone, one_worker, rule);
  CHECK_FALSE(plain.lost_grains().empty()); // or nothing is tested
  const auto pairs = joined(backbone);
  const IncompleteFactor<6> factor = factor_with_soft_first<6>(a, {}, rule, one_worker, backbone);
  CHECK(factor.lost_grains().empty());
  CHECK(joined(backbone) == pairs);
}

TEST_CASE("a stop ends the search for a numbering after a factor") {
  const packing::Assembly a = samples::large_network(28, 0.235 + 0.045 * 4 / 11, 1, 6004);
  int asked = 0;
  const auto lost_when = [&](bool stopped) {
    asked = 0;
    ResponseOptions options;
    options.stop_requested = [&asked, stopped] {
      ++asked;
      return stopped;
    };
    Backbone backbone = load_bearing_network(a, options);
    const FactorRule rule = factor_rules(backbone).front();
    return !factor_with_soft_first<6>(a, options, rule, one_worker, backbone).lost_grains().empty();
  };
  CHECK_FALSE(lost_when(false));
  CHECK(asked > 0); // or nothing is tested
  CHECK(lost_when(true));
  CHECK(asked == 1);
}
