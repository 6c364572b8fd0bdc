// SPDX-License-Identifier: GPL-3.0-or-later
#include "numbering.hpp"

#include <algorithm>
#include <span>
#include <tuple>

#include "halving.hpp"

namespace granum::network {

namespace {

// Smaller halves are not worth a layer between them.
constexpr std::size_t smallest_half = 3000;
constexpr std::size_t most_halvings = 4;

using Neighbours = std::vector<std::vector<std::uint32_t>>;

/// Neighbours of every grain that bears load.
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

class Counter {
 public:
  Counter(const Neighbours& neighbours, const std::vector<Vec3>& position)
      : neighbours_(neighbours), position_(position), group_(neighbours.size(), 0) {
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
  void divide(std::span<std::uint32_t> grains, std::size_t halvings) {
    if (halvings == 0)
      return count(grains, 0);
    const std::size_t half = halve(position_, grains);
    const std::uint32_t second = new_group(grains.subspan(half));
    const auto layer = std::partition(grains.begin(), grains.begin() + static_cast<std::ptrdiff_t>(half),
                                      [&](std::uint32_t g) { return !touches(g, second); });
    const auto first = static_cast<std::size_t>(layer - grains.begin());
    divide(grains.subspan(half), halvings - 1);
    divide(grains.first(first), halvings - 1);
    count(grains.subspan(first, half - first), halvings);
  }

  std::uint32_t new_group(std::span<const std::uint32_t> grains) {
    ++groups_;
    for (const std::uint32_t g : grains)
      group_[g] = groups_;
    return groups_;
  }

  [[nodiscard]] bool touches(std::uint32_t g, std::uint32_t group) const {
    return std::any_of(neighbours_[g].begin(), neighbours_[g].end(),
                       [&](std::uint32_t h) { return group_[h] == group; });
  }

  [[nodiscard]] bool fewer_contacts(std::uint32_t g, std::uint32_t h) const {
    return std::tuple(neighbours_[g].size(), g) < std::tuple(neighbours_[h].size(), h);
  }

  /// Reverse Cuthill-McKee of the grains of one piece, cluster after cluster.
  void count(std::span<std::uint32_t> grains, std::size_t stage) {
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
    const std::uint32_t first = counted_;
    counted_ += static_cast<std::uint32_t>(order.size());
    for (std::size_t k = 0; k < order.size(); ++k)
      numbering_.number[order[k]] = counted_ - 1 - static_cast<std::uint32_t>(k);
    numbering_.stages[stage].push_back({first, counted_});
  }

  const Neighbours& neighbours_;
  const std::vector<Vec3>& position_;
  std::vector<std::uint32_t> group_; ///< that a grain is in at present; 0: none
  std::uint32_t groups_ = 0;
  std::uint32_t counted_ = 0;
  Numbering numbering_;
};

} // namespace

Numbering number_grains(const packing::Assembly& assembly, const std::vector<bool>& rattler,
                        const std::vector<Vec3>& position) {
  std::vector<std::uint32_t> grains;
  for (std::uint32_t g = 0; g < assembly.grain_count(); ++g)
    if (!rattler[g])
      grains.push_back(g);
  return Counter(adjacency(assembly, rattler), position).run(std::move(grains));
}

} // namespace granum::network
