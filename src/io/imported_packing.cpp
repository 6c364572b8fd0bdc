// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/imported_packing.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <tuple>
#include <utility>

#include <granum/core/units.hpp>

namespace granum::io {

namespace {

using packing::Contact;

/// Halves of the doubled cell: the copy of the second grain that a contact of the first leads to.
std::uint32_t other_copy(const packing::Assembly& assembly, const Mat3& to_parts, const Contact& c,
                         int axis) {
  const Vec3 apart = assembly.position[c.i] + c.branch - assembly.position[c.j];
  const auto edges = static_cast<long long>(std::llround((to_parts * apart)[axis]));
  return edges % 2 != 0 ? 1 : 0;
}

Contact between(Contact c, std::uint32_t i, std::uint32_t j) {
  c.i = i;
  c.j = j;
  if (i > j) {
    std::swap(c.i, c.j);
    c.branch = -c.branch;
    c.tangential_force = -c.tangential_force;
  }
  return c;
}

/// The cell edge along a contact of a grain with its own image; -1 if there is none.
int edge_of_own_contact(const ImportedPacking& packing) {
  const packing::Assembly& assembly = packing.assembly;
  const Mat3 to_parts = inverse_of(assembly.cell);
  for (const Contact& c : assembly.contacts)
    if (c.i == c.j)
      for (int k = 0; k < 3; ++k)
        if (packing.periodic[static_cast<std::size_t>(k)] && std::llround((to_parts * c.branch)[k]) % 2 != 0)
          return k;
  return -1;
}

/// The periodic edge along which an image of the largest grain is nearest; -1 where it does not touch.
int edge_of_own_image(const ImportedPacking& packing) {
  const packing::Assembly& assembly = packing.assembly;
  const double reach = 2 * *std::max_element(assembly.radius.begin(), assembly.radius.end());
  double least = reach;
  int edge = -1;
  for (int a = -1; a <= 1; ++a)
    for (int b = -1; b <= 1; ++b)
      for (int c = -1; c <= 1; ++c) {
        const int steps[3] = {a, b, c};
        Vec3 image{};
        int along = -1;
        bool allowed = true;
        for (int k = 0; k < 3; ++k)
          if (steps[k] != 0) {
            allowed = allowed && packing.periodic[static_cast<std::size_t>(k)];
            image += steps[k] * column(assembly.cell, k);
            along = along < 0 ? k : along;
          }
        if (allowed && along >= 0 && norm(image) < least) {
          least = norm(image);
          edge = along;
        }
      }
  return edge;
}

} // namespace

ImportedPacking doubled(const ImportedPacking& packing, int axis) {
  ImportedPacking out = packing;
  packing::Assembly& to = out.assembly;
  const packing::Assembly& from = packing.assembly;
  const auto count = static_cast<std::uint32_t>(from.grain_count());
  const Vec3 edge = column(from.cell, axis);
  const Mat3 to_parts = inverse_of(from.cell);
  const auto [least, largest] = std::minmax_element(packing.id.begin(), packing.id.end());
  const long range = packing.id.empty() ? 0 : *largest - *least + 1;
  for (int k = 0; k < 3; ++k)
    to.cell(k, axis) *= 2;
  const std::uint32_t bodies =
      from.body.empty() ? 0 : *std::max_element(from.body.begin(), from.body.end()) + 1;
  for (std::uint32_t g = 0; g < count; ++g) {
    to.position.push_back(from.position[g] + edge);
    to.radius.push_back(from.radius[g]);
    if (!packing.id.empty())
      out.id.push_back(packing.id[g] + range);
    if (!packing.type.empty())
      out.type.push_back(packing.type[g]);
    if (!from.body.empty())
      to.body.push_back(from.body[g] + bodies);
  }
  to.contacts.clear();
  for (const Contact& c : from.contacts) {
    const std::uint32_t over = other_copy(from, to_parts, c, axis);
    for (std::uint32_t copy = 0; copy < 2; ++copy)
      to.contacts.push_back(between(c, c.i + copy * count, c.j + (copy + over) % 2 * count));
  }
  // Contacts of one pair through several images are in the order of their branches; turned ones were not.
  std::stable_sort(to.contacts.begin(), to.contacts.end(), [](const Contact& a, const Contact& b) {
    return std::tie(a.i, a.j, a.branch.x, a.branch.y, a.branch.z) <
           std::tie(b.i, b.j, b.branch.x, b.branch.y, b.branch.z);
  });
  for (const Contact& c : from.wall_contacts) {
    to.wall_contacts.push_back(c);
    to.wall_contacts.back().i += count;
  }
  return out;
}

ImportedPacking without_own_images(ImportedPacking packing) {
  constexpr int most = 6; // doublings: 64 copies
  constexpr std::size_t too_many = 10'000'000;
  const auto edge = [](const ImportedPacking& p) {
    const int of_contact = edge_of_own_contact(p);
    return of_contact >= 0 || !p.assembly.contacts.empty() ? of_contact : edge_of_own_image(p);
  };
  if (packing.assembly.grain_count() == 0 || edge(packing) < 0)
    return packing;
  const std::size_t grains = packing.assembly.grain_count();
  for (int k = 0; k < most && packing.assembly.grain_count() < too_many; ++k) {
    const int axis = edge(packing);
    if (axis < 0)
      break;
    packing = doubled(packing, axis);
  }
  packing.notes.push_back({Finding::own_image, "a grain touches its own image: the packing is repeated " +
                                                   std::to_string(packing.assembly.grain_count() / grains) +
                                                   " times"});
  return packing;
}

namespace {

/// The thickest slab across an edge of the cell without any grain, in parts of the edge.
struct EmptySlab {
  double begin = 0; ///< where grains begin behind it; those from there on come before the others
  double length = 0;
};

EmptySlab empty_slab(const ImportedPacking& packing, const Mat3& to_parts, int axis) {
  const packing::Assembly& assembly = packing.assembly;
  const bool periodic = packing.periodic[static_cast<std::size_t>(axis)];
  const double width = packing::cell_widths(assembly.cell)[axis];
  std::vector<std::pair<double, double>> grains; // from, to
  for (std::size_t g = 0; g < assembly.grain_count(); ++g) {
    const double part = (to_parts * assembly.position[g])[axis], radius = assembly.radius[g] / width;
    const double place = periodic ? part - std::floor(part) : part;
    grains.emplace_back(place - radius, place + radius);
  }
  std::ranges::sort(grains);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double first = infinity, end = infinity;
  EmptySlab out;
  for (const auto& [from, to] : grains) {
    first = std::min(first, from);
    if (periodic && from - end > out.length)
      out = {.begin = from, .length = from - end};
    end = end < infinity ? std::max(end, to) : to;
  }
  if (const double around = 1 + first - end; around > out.length)
    out = {.begin = first, .length = around};
  return out;
}

} // namespace

ImportedPacking without_air(ImportedPacking packing) {
  constexpr std::size_t fewest = 100;
  constexpr double thick = 2, gas = 0.1; // mean diameters; solid fraction
  packing::Assembly& assembly = packing.assembly;
  if (assembly.grain_count() < fewest)
    return packing;
  double squares = 0, cubes = 0;
  for (const double r : assembly.radius) {
    squares += r * r;
    cubes += r * r * r;
  }
  const Mat3 to_parts = inverse_of(assembly.cell);
  const Vec3 widths = packing::cell_widths(assembly.cell);
  std::array<EmptySlab, 3> slabs;
  double left = assembly.volume();
  for (std::size_t k = 0; k < 3; ++k) {
    const int axis = static_cast<int>(k);
    slabs[k] = empty_slab(packing, to_parts, axis);
    if (slabs[k].length * widths[axis] <= thick * 2 * cubes / squares)
      slabs[k].length = 0;
    left *= 1 - slabs[k].length;
  }
  if (4 * std::numbers::pi / 3 * cubes < gas * left)
    return packing;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& [begin, length] = slabs[k];
    if (length == 0)
      continue;
    const int axis = static_cast<int>(k);
    const Vec3 edge = column(assembly.cell, axis);
    for (Vec3& x : assembly.position)
      if (const double turns = std::floor((to_parts * x)[axis] - begin); packing.periodic[k] && turns != 0)
        x -= turns * edge;
    for (int row = 0; row < 3; ++row)
      assembly.cell(row, axis) *= 1 - length;
    packing.periodic[k] = false;
    packing.notes.push_back({Finding::air_left_out,
                             pretty(length * widths[axis], Dimension::length) + " of the box along " +
                                 "xyz"[axis] + " are empty, of " + pretty(widths[axis], Dimension::length) +
                                 ": the box ends where the grains do, without a periodic face there"});
  }
  return packing;
}

} // namespace granum::io
