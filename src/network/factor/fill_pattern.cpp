// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill_pattern.hpp"

#include <algorithm>
#include <utility>

namespace granum::network {

namespace {

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
