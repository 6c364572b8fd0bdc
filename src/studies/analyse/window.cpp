// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/analyse/window.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/core/units.hpp>

namespace granum::studies {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// How far the grains reach along an axis.
std::pair<double, double> extent(const packing::Assembly& assembly, int axis) {
  double low = infinity, high = -infinity;
  for (std::size_t g = 0; g < assembly.grain_count(); ++g) {
    low = std::min(low, assembly.position[g][axis] - assembly.radius[g]);
    high = std::max(high, assembly.position[g][axis] + assembly.radius[g]);
  }
  return {low, high};
}

/// The highest point of a grain with a contact.
double top_of(const packing::Assembly& assembly) {
  double top = -infinity;
  const auto look = [&](std::uint32_t g) {
    top = std::max(top, assembly.position[g].z + assembly.radius[g]);
  };
  for (const packing::Contact& c : assembly.contacts) {
    look(c.i);
    look(c.j);
  }
  for (const packing::Contact& c : assembly.wall_contacts)
    look(c.i);
  if (top == -infinity)
    throw InvalidArgument("--depth needs contacts: no grain of the packing has one");
  return top;
}

} // namespace

std::optional<WindowChoice> interior_window(const io::ImportedPacking& packing) {
  constexpr double away = 2.5, nearest = 2, wanted = 5, least = 3; // mean diameters
  constexpr std::size_t fewest = 200;                              // grains that have an interior
  const packing::Assembly& assembly = packing.assembly;
  if (assembly.grain_count() < fewest || assembly.contacts.empty() ||
      (packing.periodic[0] && packing.periodic[1] && packing.periodic[2]))
    return std::nullopt;
  double squares = 0, cubes = 0;
  for (const double r : assembly.radius) {
    squares += r * r;
    cubes += r * r * r;
  }
  const double diameter = 2 * cubes / squares;
  WindowChoice choice;
  for (int axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    if (packing.periodic[k])
      continue;
    auto [low, high] = extent(assembly, axis);
    if (axis == 2)
      high = std::min(high, top_of(assembly)); // grains in flight are above
    const double layer = (high - low - 2 * away * diameter < wanted * diameter ? nearest : away) * diameter;
    if (high - low - 2 * layer < least * diameter)
      return std::nullopt;
    choice.low[k] = low + layer;
    choice.high[k] = high - layer;
  }
  const auto inside = [&](const packing::Contact& c) {
    const Vec3 middle = assembly.position[c.i] + 0.5 * c.branch;
    for (int axis = 0; axis < 3; ++axis) {
      const auto k = static_cast<std::size_t>(axis);
      if (choice.low[k] && (middle[axis] < *choice.low[k] || middle[axis] > *choice.high[k]))
        return false;
    }
    return true;
  };
  constexpr std::ptrdiff_t enough = 100; // contacts for a fabric and for z*
  if (std::count_if(assembly.contacts.begin(), assembly.contacts.end(), inside) < enough)
    return std::nullopt;
  return choice;
}

analysis::Window window_in(const io::ImportedPacking& packing, const WindowChoice& choice) {
  const packing::Assembly& assembly = packing.assembly;
  const Vec3 edge = packing::cell_widths(assembly.cell);
  analysis::Window window;
  WindowChoice asked = choice;
  if (asked.depth) {
    const double top = top_of(assembly);
    asked.low[2] = top - asked.depth->second;
    asked.high[2] = top - asked.depth->first;
  }
  for (int axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    auto [low, high] = extent(assembly, axis);
    if (packing.periodic[k]) // any stretch of one edge is the whole
      high = asked.low[k].value_or(low) + edge[axis];
    high = std::min(high, asked.low[k].value_or(low) + edge[axis]);
    const double from =
        asked.low[k].value_or(packing.periodic[k] && asked.high[k] ? *asked.high[k] - edge[axis] : low);
    const double to = asked.high[k].value_or(high);
    constexpr double rounding = 1e-9;
    const double slack = rounding * edge[axis];
    if (!(from < to))
      throw InvalidArgument(std::string("the window has no width along ") + "xyz"[axis]);
    if (!packing.periodic[k] &&
        (to > extent(assembly, axis).second + slack || from < extent(assembly, axis).first - slack))
      throw InvalidArgument(std::string("the window reaches beyond the grains along ") + "xyz"[axis] +
                            ", which lie from " + pretty(extent(assembly, axis).first, Dimension::length) +
                            " to " + pretty(extent(assembly, axis).second, Dimension::length));
    window.low[axis] = from;
    window.high[axis] = to;
  }
  return window;
}

} // namespace granum::studies
