// SPDX-License-Identifier: GPL-3.0-or-later
#include "factor_rule.hpp"

#include <algorithm>

namespace granum::network {

namespace {

// Springs over unknowns, below which a network is hardly rigid: 1.1 in loose packings, 1.5 in dense ones.
// There level 1 loses the sign of pivots, 28 in 400,000 loose grains, which take 102 iterations with level 3
// and more than 1400 with level 1; dense ones gain no time by it.
constexpr double hardly_rigid = 1.3;
// And below which it is floppy. A factor with more fill nearly holds its free modes, and 1 over their pivots
// blows rounding up: with level 3, 16 of 368 random networks do not arrive, with level 1 only 2.
constexpr double floppy = 1.08;
// Grains from which on a hardly rigid network gains time by pivots that are judged: soft motions of a few
// grains, which the shift stiffens, and lost pivots grow in number with it.
constexpr std::size_t many_grains = 20000;

/// Springs over unknowns. A contact is three springs, or one where none has tangential stiffness.
double rigidity(const Backbone& backbone) {
  const auto contacts = static_cast<double>(backbone.links.size() + backbone.wall_links.size());
  return contacts * (backbone.rotations ? 3 : 1) /
         (static_cast<double>(backbone.grain_count) * (backbone.rotations ? 6 : 3));
}

std::vector<FactorRule> suitable_rules(const Backbone& backbone) {
  const double springs = rigidity(backbone);
  if (springs < floppy)
    return {{.fill_level = 1, .soft_pivots = SoftPivots::stiffened}};
  if (springs >= hardly_rigid)
    return {{.fill_level = 1}};
  if (backbone.grain_count < many_grains)
    return {{.fill_level = 3}};
  return {{.fill_level = 3, .shift = 1e-12, .soft_pivots = SoftPivots::judged},
          {.fill_level = 3, .shift = 1e-12, .soft_pivots = SoftPivots::coupled},
          {.fill_level = 3}};
}

} // namespace

std::vector<FactorRule> factor_rules(const Backbone& backbone) {
  std::vector<FactorRule> rules = suitable_rules(backbone);
  for (const FactorRule& other :
       {FactorRule{.fill_level = 2}, FactorRule{.fill_level = 3, .shift = 1e-4}, FactorRule{.fill_level = 1}})
    if (std::find(rules.begin(), rules.end(), other) == rules.end())
      rules.push_back(other);
  return rules;
}

} // namespace granum::network
