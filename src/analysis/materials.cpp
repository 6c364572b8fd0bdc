// SPDX-License-Identifier: GPL-3.0-or-later
#include "materials.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include <granum/contact/grains.hpp>
#include <granum/core/error.hpp>

namespace granum::analysis {

namespace {

constexpr double hertz_exponent = 1.0 / 3; // k_n ~ f^b

contact::GrainMaterial touching(const packing::Contact& c, std::span<const contact::GrainMaterial> of_grain) {
  return contact::pair_material(of_grain[c.i], of_grain[c.j]);
}

} // namespace

effective::MixedContacts mixed_contacts(const packing::Assembly& assembly,
                                        std::span<const contact::GrainMaterial> materials) {
  if (materials.size() != assembly.grain_count())
    throw InvalidArgument("there must be one material for each grain");
  std::vector<effective::MaterialPair> pairs;
  pairs.reserve(assembly.contacts.size());
  for (const packing::Contact& c : assembly.contacts) {
    const double length = assembly.radius[c.i] + assembly.radius[c.j];
    pairs.push_back({.material = touching(c, materials),
                     .weight = length * length,
                     .force = std::max(c.normal_force, 0.0)});
  }
  return effective::mixed_contacts(pairs, hertz_exponent);
}

std::vector<double> relative_stiffnesses(const packing::Assembly& assembly,
                                         std::span<const contact::GrainMaterial> materials,
                                         const contact::GrainMaterial& mean) {
  std::vector<double> relative;
  if (materials.empty())
    return relative;
  relative.reserve(assembly.contacts.size());
  for (const packing::Contact& c : assembly.contacts)
    relative.push_back(effective::relative_stiffness(touching(c, materials), mean, hertz_exponent));
  return relative;
}

bool factors_differ(const packing::Assembly& assembly, std::span<const long> type) {
  constexpr std::size_t fewest = 5;
  constexpr double apart = 1.02;
  if (type.size() != assembly.grain_count())
    return false;
  std::map<std::pair<long, long>, std::vector<double>> factors;
  for (const packing::Contact& c : assembly.contacts)
    if (c.overlap > 0 && c.normal_force > 0) {
      const double radius = contact::pair_radius(assembly.radius[c.i], assembly.radius[c.j]);
      factors[std::minmax({type[c.i], type[c.j]})].push_back(c.normal_force / std::sqrt(radius) /
                                                             (c.overlap * std::sqrt(c.overlap)));
    }
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (auto& [types, values] : factors) {
    if (values.size() < fewest)
      continue;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    least = std::min(least, *middle);
    most = std::max(most, *middle);
  }
  return most > apart * least;
}

} // namespace granum::analysis
