// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill_pattern.hpp"

#include <algorithm>
#include <utility>

namespace granum::network {

namespace {

// Springs over unknowns, below which a network is hardly rigid: 1.1 in loose packings, 1.5 in dense ones.
// There level 1 loses the sign of pivots, 28 in 400,000 loose grains, which take 102 iterations with level 3
// and more than 1400 with level 1; dense ones gain no time by it.
constexpr double hardly_rigid = 1.3;
// And below which it is floppy. A factor with more fill nearly holds its free modes, and 1 over their pivots
// blows rounding up: with level 3, 16 of 368 random networks do not arrive, with level 1 only 2.
constexpr double floppy = 1.08;
// A level more makes some 1.8 times as many blocks; one that would surely be too large is not tried.
constexpr double least_growth = 1.6;

/// A grain eliminated later, and the level of its coupling.
struct Later {
  std::uint32_t grain;
  int level;
};

/// Leaves each grain once, at its least level.
void keep_least(std::vector<Later>& list) {
  std::sort(list.begin(), list.end(), [](const Later& x, const Later& y) {
    return std::pair(x.grain, x.level) < std::pair(y.grain, y.level);
  });
  list.erase(std::unique(list.begin(), list.end(),
                         [](const Later& x, const Later& y) { return x.grain == y.grain; }),
             list.end());
}

/// Springs over unknowns. A contact is three springs, or one where none has tangential stiffness.
double rigidity(const Backbone& backbone) {
  const auto contacts = static_cast<double>(backbone.links.size() + backbone.wall_links.size());
  return contacts * (backbone.rotations ? 3 : 1) /
         (static_cast<double>(backbone.grain_count) * (backbone.rotations ? 6 : 3));
}

} // namespace

bool is_floppy(const Backbone& backbone) { return rigidity(backbone) < floppy; }

FillPattern fill_pattern(const Backbone& backbone, int most_level) {
  std::vector<std::vector<Later>> couplings(backbone.grain_count);
  std::vector<std::vector<std::uint32_t>> rows(backbone.grain_count);
  for (const Link& l : backbone.links)
    couplings[l.a].push_back({l.b, 0});
  for (std::uint32_t j = 0; j < backbone.grain_count; ++j) {
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

FillPattern suitable_fill_pattern(const Backbone& backbone, double most_blocks) {
  const double most = most_blocks * static_cast<double>(backbone.grain_count);
  const int highest_level = !is_floppy(backbone) && rigidity(backbone) < hardly_rigid ? 3 : 1;
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
