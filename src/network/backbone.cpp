// SPDX-License-Identifier: GPL-3.0-or-later
#include "backbone.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <granum/packing/coordination.hpp>

namespace granum::network {

namespace {

constexpr std::uint32_t unset = Numbering::unset;

double effective_tangential_stiffness(const packing::Contact& c, SlidingContacts sliding) {
  return c.sliding && sliding == SlidingContacts::release ? 0 : c.tangential_stiffness;
}

/// With the units of the contact.
Link link(const packing::Contact& c, std::uint32_t i, std::uint32_t j, double radii,
          const ResponseOptions& options) {
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

LoadedContact loaded(const packing::Contact& c, std::uint32_t i, std::uint32_t j, double radii) {
  // k_n ~ overlap^(1/alpha), 1 + 1/alpha = k_n overlap/f, and k_t goes with it
  const bool pressed = c.normal_force > 0 && c.overlap > 0;
  return {.i = i,
          .j = j,
          .branch = c.branch,
          .lever = norm(c.branch) / radii,
          .normal_force = c.normal_force,
          .tangential_force = c.tangential_force,
          .tangential_share = pressed ? c.normal_stiffness / c.normal_force - 1 / c.overlap : 0};
}

/// Every centre, moved into the cell.
std::vector<Vec3> inside(const packing::Assembly& assembly) {
  const Mat3 to_parts = inverse_of(assembly.cell);
  std::vector<Vec3> centre;
  centre.reserve(assembly.grain_count());
  for (const Vec3& x : assembly.position) {
    Vec3 part = to_parts * x;
    for (int k = 0; k < 3; ++k)
      part[k] -= std::floor(part[k]);
    centre.push_back(assembly.cell * part);
  }
  return centre;
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
  const double per_force = 1 / (backbone.stiffness_scale * backbone.length_scale);
  for (LoadedContact& c : backbone.loaded) {
    c.branch *= 1 / backbone.length_scale;
    c.normal_force *= per_force;
    c.tangential_force *= per_force;
    c.tangential_share *= backbone.length_scale;
  }
  for (Vec3& x : backbone.centre)
    x *= 1 / backbone.length_scale;
  backbone.cell = (1 / backbone.length_scale) * backbone.cell;
  for (double& r : backbone.radius)
    r /= backbone.length_scale;
}

} // namespace

Backbone load_bearing_network(const packing::Assembly& assembly, const ResponseOptions& options,
                              const std::vector<bool>& soft) {
  Backbone backbone;
  for (const auto* contacts : {&assembly.contacts, &assembly.wall_contacts})
    for (const packing::Contact& c : *contacts)
      backbone.rotations |= effective_tangential_stiffness(c, options.sliding) > 0;
  const auto mechanics = mechanical_coordination(
      assembly, backbone.rotations ? packing::ContactKind::frictional : packing::ContactKind::frictionless);
  backbone.grain_count = assembly.grain_count() - mechanics.rattler_count;
  if (mechanics.contact_count + mechanics.wall_contact_count == 0)
    return backbone;

  backbone.cell = assembly.cell;
  const std::vector<Vec3> centre = inside(assembly);
  auto [number, stages] = number_grains(assembly, mechanics.rattler, centre, soft);
  backbone.stages = std::move(stages);
  backbone.grain.resize(backbone.grain_count);
  backbone.centre.resize(backbone.grain_count);
  backbone.radius.resize(backbone.grain_count);
  for (std::uint32_t g = 0; g < number.size(); ++g)
    if (number[g] != unset) {
      backbone.grain[number[g]] = g;
      backbone.centre[number[g]] = centre[g];
      backbone.radius[number[g]] = assembly.radius[g];
    }
  for (const packing::Contact& c : assembly.contacts)
    if (number[c.i] != unset && number[c.j] != unset) {
      const double radii = assembly.radius[c.i] + assembly.radius[c.j];
      backbone.links.push_back(link(c, number[c.i], number[c.j], radii, options));
      if (options.force_terms)
        backbone.loaded.push_back(loaded(c, number[c.i], number[c.j], radii));
    }
  for (const packing::Contact& c : assembly.wall_contacts)
    if (number[c.i] != unset)
      backbone.wall_links.push_back(link(c, number[c.i], number[c.i], assembly.radius[c.i], options));
  remove_units(backbone);
  std::stable_sort(backbone.links.begin(), backbone.links.end(),
                   [](const Link& l, const Link& m) { return std::pair(l.b, l.a) < std::pair(m.b, m.a); });
  std::stable_sort(backbone.wall_links.begin(), backbone.wall_links.end(),
                   [](const Link& l, const Link& m) { return l.a < m.a; });
  return backbone;
}

} // namespace granum::network
