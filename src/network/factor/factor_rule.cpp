// SPDX-License-Identifier: GPL-3.0-or-later
#include "factor_rule.hpp"

#include <algorithm>

namespace granum::network {

namespace {

// Springs per unknown below which a network is hardly rigid (loose packings 1.1, dense 1.5). With level 1 it
// loses the sign of pivots: 400,000 loose grains take more than 1400 iterations, with level 3 102. Dense ones
// gain no time by level 3.
constexpr double hardly_rigid = 1.3;
// Springs per unknown below which a network is treated as floppy: more fill makes pivots of free modes nearly
// zero, and their inverses amplify rounding. With level 3, 16 of 368 random networks fail, with level 1 two.
constexpr double floppy = 1.08;
// Least number of grains for which a hardly rigid network gains time by SoftPivots::by_motion: soft motions
// and lost pivots grow in number with it.
constexpr std::size_t many_grains = 20000;

/// Springs per unknown. A contact is three springs, or one in networks without tangential stiffness.
double rigidity(const Backbone& backbone) {
  const auto contacts = static_cast<double>(backbone.links.size() + backbone.wall_links.size());
  return contacts * (backbone.rotations ? 3 : 1) /
         (static_cast<double>(backbone.grain_count) * (backbone.rotations ? 6 : 3));
}

std::vector<FactorRule> chosen_rules(const Backbone& backbone) {
  const double springs = rigidity(backbone);
  if (springs < floppy)
    return {{.fill_level = 1, .soft_pivots = SoftPivots::stiffened}};
  if (springs >= hardly_rigid)
    return {{.fill_level = 1}};
  if (backbone.grain_count < many_grains)
    return {{.fill_level = 3}};
  return {{.fill_level = 3, .shift = 1e-12, .soft_pivots = SoftPivots::by_motion},
          {.fill_level = 3, .shift = 1e-12, .soft_pivots = SoftPivots::coupled},
          {.fill_level = 3}};
}

} // namespace

std::vector<FactorRule> factor_rules(const Backbone& backbone) {
  std::vector<FactorRule> rules = chosen_rules(backbone);
  for (const FactorRule& other :
       {FactorRule{.fill_level = 2}, FactorRule{.fill_level = 3, .shift = 1e-4}, FactorRule{.fill_level = 1}})
    if (std::find(rules.begin(), rules.end(), other) == rules.end())
      rules.push_back(other);
  return rules;
}

} // namespace granum::network
