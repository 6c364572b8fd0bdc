// SPDX-License-Identifier: GPL-3.0-or-later
#include "elimination.hpp"

#include <algorithm>
#include <utility>

#include <granum/core/stop.hpp>

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

// A further level has about 1.8 times as many blocks; a level that is certainly too large is not tried.
constexpr double least_growth = 1.6;

/// A grain eliminated later, and the level of its coupling.
struct Later {
  std::uint32_t grain;
  int level;
};

/// Keeps each grain once, with its least level.
void keep_least(std::vector<Later>& list) {
  std::sort(list.begin(), list.end(), [](const Later& x, const Later& y) {
    return std::pair(x.grain, x.level) < std::pair(y.grain, y.level);
  });
  list.erase(std::unique(list.begin(), list.end(),
                         [](const Later& x, const Later& y) { return x.grain == y.grain; }),
             list.end());
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

FillPattern fill_pattern(const Backbone& backbone, int most_level) {
  std::vector<std::vector<Later>> couplings(backbone.grain_count);
  std::vector<std::vector<std::uint32_t>> rows(backbone.grain_count);
  for (const Link& l : backbone.links)
    couplings[l.a].push_back({l.b, 0});
  for (std::uint32_t j = 0; j < backbone.grain_count; ++j) {
    stop_point(j);
    keep_least(couplings[j]);
    const std::vector<Later> later = std::exchange(couplings[j], {});
    for (const Later& k : later) {
      rows[k.grain].push_back(j);
      for (const Later& i : later)
        if (const int level = k.level + i.level + 1; k.grain < i.grain && level <= most_level)
          couplings[k.grain].push_back({i.grain, level});
    }
  }
  FillPattern pattern{.row_start = {0}, .column = {}};
  pattern.row_start.reserve(rows.size() + 1);
  for (auto& row : rows) {
    pattern.column.insert(pattern.column.end(), row.begin(), row.end());
    pattern.row_start.push_back(static_cast<std::uint32_t>(pattern.column.size()));
    std::vector<std::uint32_t>().swap(row);
  }
  return pattern;
}

FillPattern fill_pattern_within(const Backbone& backbone, int highest_level, double most_blocks) {
  const double most = most_blocks * static_cast<double>(backbone.grain_count);
  FillPattern pattern = fill_pattern(backbone, 1);
  for (int level = 2; level <= highest_level && least_growth * static_cast<double>(pattern.size()) <= most;
       ++level) {
    FillPattern next = fill_pattern(backbone, level);
    if (static_cast<double>(next.size()) > most)
      break;
    pattern = std::move(next);
  }
  return pattern;
}

} // namespace granum::network
