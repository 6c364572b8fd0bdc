// SPDX-License-Identifier: GPL-3.0-or-later
#include "materials.hpp"

#include <algorithm>

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

} // namespace granum::analysis
