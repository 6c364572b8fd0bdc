// SPDX-License-Identifier: GPL-3.0-or-later
#include "weakly_supported.hpp"

#include <algorithm>
#include <cstddef>

namespace granum::network {

namespace {

bool is_bar(const std::vector<std::uint32_t>& neighbours) { return neighbours.size() <= 2; }

bool is_weakly_supported(const Neighbours& neighbours, std::uint32_t g) {
  if (is_bar(neighbours[g]))
    return true;
  const auto bars = std::count_if(neighbours[g].begin(), neighbours[g].end(),
                                  [&](std::uint32_t h) { return is_bar(neighbours[h]); });
  return 3 * static_cast<std::ptrdiff_t>(neighbours[g].size()) - 2 * bars <= 7;
}

} // namespace

WeaklySupported::WeaklySupported(const Neighbours& neighbours, const std::vector<bool>& soft)
    : first_(neighbours.size(), none) {
  std::vector<bool> waits(neighbours.size());
  for (std::uint32_t g = 0; g < neighbours.size(); ++g)
    waits[g] = is_weakly_supported(neighbours, g) || (!soft.empty() && soft[g]);
  std::vector<std::uint32_t> reached;
  const auto reach = [&](std::uint32_t g, std::uint32_t first) {
    if (!waits[g])
      return;
    waits[g] = false;
    first_[g] = first;
    reached.push_back(g);
  };
  for (std::uint32_t first = 0; first < neighbours.size(); ++first) {
    reach(first, first);
    while (!reached.empty()) {
      const std::uint32_t g = reached.back();
      reached.pop_back();
      for (const std::uint32_t h : neighbours[g])
        reach(h, first);
    }
  }
}

} // namespace granum::network
