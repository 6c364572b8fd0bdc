// SPDX-License-Identifier: GPL-3.0-or-later
#include "halving.hpp"

#include <algorithm>
#include <utility>

namespace granum::network {

std::size_t halve(const std::vector<Vec3>& position, std::span<std::uint32_t> points) {
  Vec3 low = position[points.front()], high = low;
  for (const std::uint32_t p : points)
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], position[p][k]);
      high[k] = std::max(high[k], position[p][k]);
    }
  const Vec3 side = high - low;
  int axis = 0;
  for (int k = 1; k < 3; ++k)
    if (side[k] > side[axis])
      axis = k;
  const std::size_t half = points.size() / 2;
  std::nth_element(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(half), points.end(),
                   [&](std::uint32_t p, std::uint32_t q) {
                     return std::pair(position[p][axis], p) < std::pair(position[q][axis], q);
                   });
  return half;
}

} // namespace granum::network
