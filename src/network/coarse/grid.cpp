// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace granum::network {

CoarseGrid::CoarseGrid(const Backbone& backbone, double grains_a_box)
    : part_(backbone.grain_count), box_(backbone.grain_count), grains_(backbone.grain_count) {
  const Vec3 width = packing::cell_widths(backbone.cell);
  const double edge =
      std::cbrt(determinant(backbone.cell) * grains_a_box / static_cast<double>(backbone.grain_count));
  for (unsigned k = 0; k < 3; ++k)
    along_[k] = static_cast<std::size_t>(std::max(1.0, std::round(width[static_cast<int>(k)] / edge)));
  grains_start_.assign(along_[0] * along_[1] * along_[2] + 1, 0);

  const Mat3 to_parts = inverse_of(backbone.cell);
  for (std::size_t g = 0; g < backbone.grain_count; ++g) {
    const Vec3 part = to_parts * backbone.centre[g];
    std::size_t box = 0;
    for (unsigned k = 0; k < 3; ++k) {
      const int axis = static_cast<int>(k);
      const double place = part[axis] * static_cast<double>(along_[k]);
      const double before = std::clamp(std::floor(place), 0.0, static_cast<double>(along_[k] - 1));
      part_[g][axis] = std::clamp(place - before, 0.0, 1.0);
      box = box * along_[k] + static_cast<std::size_t>(before);
    }
    box_[g] = static_cast<std::uint32_t>(box);
    ++grains_start_[box + 1];
  }
  std::partial_sum(grains_start_.begin(), grains_start_.end(), grains_start_.begin());
  std::vector<std::uint32_t> next(grains_start_.begin(), grains_start_.end() - 1);
  for (std::uint32_t g = 0; g < backbone.grain_count; ++g)
    grains_[next[box_[g]]++] = g;
}

/// The boxes or nodes one step further along each set of axes.
CoarseGrid::Corners CoarseGrid::neighbours(std::size_t number, int direction) const {
  const std::array<std::size_t, 3> here{number / along_[2] / along_[1], number / along_[2] % along_[1],
                                        number % along_[2]};
  Corners all{};
  for (unsigned c = 0; c < all.size(); ++c) {
    std::size_t there = 0;
    for (unsigned k = 0; k < 3; ++k) {
      const std::size_t step = (c >> k & 1U) == 0 ? 0 : direction > 0 ? 1 : along_[k] - 1;
      there = there * along_[k] + (here[k] + step) % along_[k];
    }
    all[c] = static_cast<std::uint32_t>(there);
  }
  return all;
}

} // namespace granum::network
