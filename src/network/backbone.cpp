// SPDX-License-Identifier: GPL-3.0-or-later
#include "backbone.hpp"

#include <algorithm>
#include <tuple>

#include <granum/packing/coordination.hpp>

namespace granum::network {

namespace {

constexpr std::uint32_t unset = ~std::uint32_t{0};

double effective_tangential_stiffness(const packing::Contact& c, SlidingContacts sliding) {
  return c.sliding && sliding == SlidingContacts::release ? 0 : c.tangential_stiffness;
}

/// Neighbours of every grain that bears load.
std::vector<std::vector<std::uint32_t>> adjacency(const packing::Assembly& assembly,
                                                  const std::vector<bool>& rattler) {
  std::vector<std::vector<std::uint32_t>> neighbours(assembly.grain_count());
  for (const packing::Contact& c : assembly.contacts) {
    if (rattler[c.i] || rattler[c.j])
      continue;
    neighbours[c.i].push_back(c.j);
    neighbours[c.j].push_back(c.i);
  }
  return neighbours;
}

/// New number of every grain by reverse Cuthill-McKee, component after component; `unset` for rattlers.
std::vector<std::uint32_t> renumbering(const packing::Assembly& assembly, const std::vector<bool>& rattler) {
  auto neighbours = adjacency(assembly, rattler);
  const auto fewer_contacts = [&](std::uint32_t g, std::uint32_t h) {
    return std::tuple(neighbours[g].size(), g) < std::tuple(neighbours[h].size(), h);
  };
  std::vector<std::uint32_t> seeds, order;
  for (std::uint32_t g = 0; g < neighbours.size(); ++g)
    if (!rattler[g])
      seeds.push_back(g);
  std::sort(seeds.begin(), seeds.end(), fewer_contacts);
  std::vector<bool> seen(neighbours.size(), false);
  const auto visit = [&](std::uint32_t g) {
    if (!seen[g]) {
      seen[g] = true;
      order.push_back(g);
    }
  };
  std::size_t head = 0;
  for (const std::uint32_t seed : seeds) {
    visit(seed);
    for (; head < order.size(); ++head) {
      auto next = neighbours[order[head]];
      std::sort(next.begin(), next.end(), fewer_contacts);
      for (const std::uint32_t g : next)
        visit(g);
    }
  }
  std::vector<std::uint32_t> number(neighbours.size(), unset);
  for (std::size_t k = 0; k < order.size(); ++k)
    number[order[k]] = static_cast<std::uint32_t>(order.size() - 1 - k);
  return number;
}

/// With the units of the contact.
Link link(const packing::Contact& c, std::uint32_t i, std::uint32_t j, double radii, const Options& options) {
  const double length = norm(c.branch);
  return {.a = std::min(i, j),
          .b = std::max(i, j),
          .normal = i <= j ? normal(c) : -normal(c),
          .length = length,
          .lever = length / radii,
          .normal_stiffness = c.normal_stiffness,
          .tangential_stiffness = effective_tangential_stiffness(c, options.sliding),
          .prestress = options.prestress ? c.normal_force / length : 0};
}

void remove_units(Backbone& backbone) {
  double stiffness_sum = 0, length_sum = 0;
  for (const auto* links : {&backbone.links, &backbone.wall_links})
    for (const Link& l : *links) {
      stiffness_sum += l.normal_stiffness;
      length_sum += l.length;
    }
  const auto count = static_cast<double>(backbone.links.size() + backbone.wall_links.size());
  backbone.length_scale = length_sum / count;
  if (stiffness_sum > 0)
    backbone.stiffness_scale = stiffness_sum / count;
  for (auto* links : {&backbone.links, &backbone.wall_links})
    for (Link& l : *links) {
      l.length /= backbone.length_scale;
      l.normal_stiffness /= backbone.stiffness_scale;
      l.tangential_stiffness /= backbone.stiffness_scale;
      l.prestress /= backbone.stiffness_scale;
    }
}

} // namespace

Backbone load_bearing_network(const packing::Assembly& assembly, const Options& options) {
  Backbone backbone;
  for (const auto* contacts : {&assembly.contacts, &assembly.wall_contacts})
    for (const packing::Contact& c : *contacts)
      backbone.rotations |= effective_tangential_stiffness(c, options.sliding) > 0;
  const auto mechanics = mechanical_coordination(
      assembly, backbone.rotations ? packing::ContactKind::frictional : packing::ContactKind::frictionless);
  const auto number = renumbering(assembly, mechanics.rattler);
  backbone.grain_count = assembly.grain_count() - mechanics.rattler_count;
  if (mechanics.contact_count + mechanics.wall_contact_count == 0)
    return backbone;

  for (const packing::Contact& c : assembly.contacts)
    if (number[c.i] != unset && number[c.j] != unset)
      backbone.links.push_back(
          link(c, number[c.i], number[c.j], assembly.radius[c.i] + assembly.radius[c.j], options));
  for (const packing::Contact& c : assembly.wall_contacts)
    if (number[c.i] != unset)
      backbone.wall_links.push_back(link(c, number[c.i], number[c.i], assembly.radius[c.i], options));
  remove_units(backbone);
  std::stable_sort(backbone.links.begin(), backbone.links.end(),
                   [](const Link& l, const Link& m) { return std::pair(l.a, l.b) < std::pair(m.a, m.b); });
  std::stable_sort(backbone.wall_links.begin(), backbone.wall_links.end(),
                   [](const Link& l, const Link& m) { return l.a < m.a; });
  return backbone;
}

} // namespace granum::network
