// SPDX-License-Identifier: GPL-3.0-or-later
#include "numbering.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <tuple>
#include <utility>

#include <granum/core/stop.hpp>

namespace granum::network {

namespace {

// Smaller halves are not worth a layer between them.
constexpr std::size_t smallest_half = 3000;
constexpr std::size_t most_halvings = 4;

Neighbours adjacency(const packing::Assembly& assembly, const std::vector<bool>& rattler) {
  Neighbours neighbours(assembly.grain_count());
  for (const packing::Contact& c : assembly.contacts) {
    if (rattler[c.i] || rattler[c.j])
      continue;
    neighbours[c.i].push_back(c.j);
    neighbours[c.j].push_back(c.i);
  }
  return neighbours;
}

/// Sorts points into two halves along the longest side of their bounding box; returns the number in the
/// first.
/// \param    points   numbers of points, at least 1
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

class Counter {
 public:
  Counter(const Neighbours& neighbours, const std::vector<Vec3>& position, const std::vector<bool>& soft)
      : neighbours_(neighbours), position_(position), weakly_supported_(neighbours, soft),
        group_(neighbours.size(), 0) {
    numbering_.number.assign(neighbours.size(), Numbering::unset);
  }

  Numbering run(std::vector<std::uint32_t> grains) {
    std::size_t halvings = 0;
    while (halvings < most_halvings && grains.size() >> (halvings + 1) >= smallest_half)
      ++halvings;
    numbering_.stages.resize(halvings + 1);
    divide(grains, halvings);
    return std::move(numbering_);
  }

 private:
  void divide(std::vector<std::uint32_t>& grains, std::size_t halvings) {
    stop_point();
    if (halvings == 0)
      return count(std::move(grains), 0);
    auto [first, second] = halves_of(grains);
    const std::vector<std::uint32_t> layer = take_layer(first, second);
    divide(second, halvings - 1);
    divide(first, halvings - 1);
    count(layer, halvings);
  }

  /// Clusters of weakly supported grains are not divided.
  std::array<std::vector<std::uint32_t>, 2> halves_of(std::span<std::uint32_t> grains) {
    const std::uint32_t beyond = new_group(grains.subspan(halve(position_, grains)));
    std::array<std::vector<std::uint32_t>, 2> halves;
    for (const std::uint32_t g : grains)
      halves[group_[weakly_supported_.first_of_cluster(g)] == beyond ? 1 : 0].push_back(g);
    return halves;
  }

  /// Removes the grains of the first half that touch the second. A weakly supported one stays; the grains of
  /// the second half that it touches are removed instead.
  std::vector<std::uint32_t> take_layer(std::vector<std::uint32_t>& first,
                                        std::vector<std::uint32_t>& second) {
    const std::uint32_t here = new_group(first), there = new_group(second);
    const auto touches = [&](std::uint32_t g, const auto& which) {
      return std::any_of(neighbours_[g].begin(), neighbours_[g].end(), which);
    };
    const auto parts = [&](std::uint32_t g) {
      if (weakly_supported_.contains(g))
        return false;
      if (group_[g] == here)
        return touches(g, [&](std::uint32_t h) { return group_[h] == there; });
      return touches(g, [&](std::uint32_t h) { return group_[h] == here && weakly_supported_.contains(h); });
    };
    std::vector<std::uint32_t> layer;
    for (auto* half : {&first, &second}) {
      const auto taken =
          std::stable_partition(half->begin(), half->end(), [&](std::uint32_t g) { return !parts(g); });
      layer.insert(layer.end(), taken, half->end());
      half->erase(taken, half->end());
    }
    return layer;
  }

  std::uint32_t new_group(std::span<const std::uint32_t> grains) {
    ++groups_;
    for (const std::uint32_t g : grains)
      group_[g] = groups_;
    return groups_;
  }

  [[nodiscard]] bool fewer_contacts(std::uint32_t g, std::uint32_t h) const {
    return std::tuple(neighbours_[g].size(), g) < std::tuple(neighbours_[h].size(), h);
  }

  /// Weakly supported grains, then the others, each in the order of a reverse Cuthill-McKee of the piece.
  void count(std::vector<std::uint32_t> grains, std::size_t stage) {
    const auto by_contacts = [this](std::uint32_t g, std::uint32_t h) { return fewer_contacts(g, h); };
    const std::uint32_t waiting = new_group(grains);
    std::sort(grains.begin(), grains.end(), by_contacts);
    std::vector<std::uint32_t> order, next;
    order.reserve(grains.size());
    const auto visit = [&](std::uint32_t g) {
      if (group_[g] == waiting) {
        group_[g] = 0;
        order.push_back(g);
      }
    };
    std::size_t head = 0;
    for (const std::uint32_t seed : grains) {
      visit(seed);
      for (; head < order.size(); ++head) {
        next = neighbours_[order[head]];
        std::sort(next.begin(), next.end(), by_contacts);
        for (const std::uint32_t g : next)
          visit(g);
      }
    }
    std::stable_partition(order.begin(), order.end(), // `order` is reversed below
                          [this](std::uint32_t g) { return !weakly_supported_.contains(g); });
    const std::uint32_t first = counted_;
    counted_ += static_cast<std::uint32_t>(order.size());
    for (std::size_t k = 0; k < order.size(); ++k)
      numbering_.number[order[k]] = counted_ - 1 - static_cast<std::uint32_t>(k);
    numbering_.stages[stage].push_back({first, counted_});
  }

  const Neighbours& neighbours_;
  const std::vector<Vec3>& position_;
  WeaklySupported weakly_supported_;
  std::vector<std::uint32_t> group_; ///< current group of each grain; 0: none
  std::uint32_t groups_ = 0;
  std::uint32_t counted_ = 0;
  Numbering numbering_;
};

} // namespace

Numbering number_grains(const packing::Assembly& assembly, const std::vector<bool>& rattler,
                        const std::vector<Vec3>& position, const std::vector<bool>& soft) {
  std::vector<std::uint32_t> grains;
  for (std::uint32_t g = 0; g < assembly.grain_count(); ++g)
    if (!rattler[g])
      grains.push_back(g);
  return Counter(adjacency(assembly, rattler), position, soft).run(std::move(grains));
}

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
