// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/packing/one_layer.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <granum/core/error.hpp>
#include <granum/core/units.hpp>

namespace granum::packing {

namespace {

bool is_flat_along(const Assembly& assembly, int axis) {
  constexpr double rounding = 1e-6, least = 0.8; // of the largest radius; of the largest diameter
  const double largest = *std::max_element(assembly.radius.begin(), assembly.radius.end()),
               width = cell_widths(assembly.cell)[axis];
  if (assembly.contacts.empty() && width >= least * 2 * largest && width < 2 * largest)
    return false;
  const auto none = [&](double apart) { return std::abs(apart) <= rounding * largest; };
  const auto flat = [&](const Contact& c) { return none(c.branch[axis]); };
  const auto level = [&](const Vec3& x) { return none(x[axis] - assembly.position[0][axis]); };
  const auto all = [](const auto& list, const auto& is) { return std::all_of(list.begin(), list.end(), is); };
  return all(assembly.position, level) && all(assembly.contacts, flat) && all(assembly.wall_contacts, flat);
}

} // namespace

void require_space(const Assembly& assembly) {
  constexpr std::size_t fewest = 10;
  if (assembly.grain_count() < fewest || assembly.radius.size() != assembly.grain_count())
    return;
  std::vector<int> flat;
  for (int axis = 0; axis < 3; ++axis)
    if (is_flat_along(assembly, axis))
      flat.push_back(axis);
  if (flat.size() != 1) // a row of grains is no packing in a plane
    return;
  throw InvalidArgument("all " + std::to_string(assembly.grain_count()) + " grains lie in one plane, " +
                        "xyz"[flat[0]] + " = " + pretty(assembly.position[0][flat[0]], Dimension::length) +
                        ": a packing in two dimensions. granum answers packings of spheres in space; "
                        "simulate several layers of spheres");
}

} // namespace granum::packing
