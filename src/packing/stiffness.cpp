// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/packing/stiffness.hpp>

#include <algorithm>
#include <cmath>
#include <string>

#include <granum/contact/grains.hpp>
#include <granum/core/error.hpp>

namespace granum::packing {

namespace {

void assign(Contact& c, const contact::NormalLaw& law, double ratio, StiffnessFrom from) {
  c.normal_stiffness = from == StiffnessFrom::overlap ? law.stiffness_at_overlap(std::max(c.overlap, 0.0))
                                                      : law.stiffness_at_force(std::max(c.normal_force, 0.0));
  c.tangential_stiffness = ratio * c.normal_stiffness;
}

/// A rigid plane, at which a grain has a contact as with its mirror image: F(2 d), with the derivative 2 F'(2
/// d).
void assign_wall(Contact& c, const contact::NormalLaw& law, double ratio, StiffnessFrom from) {
  Contact mirrored = c;
  mirrored.overlap = 2 * c.overlap;
  assign(mirrored, law, ratio, from);
  c.normal_stiffness = 2 * mirrored.normal_stiffness;
  c.tangential_stiffness = ratio * c.normal_stiffness;
}

void require_materials(const Assembly& assembly, std::span<const contact::GrainMaterial> materials) {
  if (materials.size() != assembly.grain_count())
    throw InvalidArgument(std::to_string(materials.size()) + " materials do not go with " +
                          std::to_string(assembly.grain_count()) + " grains");
}

} // namespace

void assign_stiffness(Assembly& assembly, const contact::NormalLaw& law, double ratio, StiffnessFrom from) {
  require_valid(assembly);
  const double checked_ratio = contact::given_stiffness_ratio(ratio);
  for (Contact& c : assembly.contacts)
    assign(c, law, checked_ratio, from);
  for (Contact& c : assembly.wall_contacts)
    assign_wall(c, law, checked_ratio, from);
}

void assign_stiffness_by_size(Assembly& assembly, const contact::NormalLaw& law, double ratio,
                              StiffnessFrom from) {
  require_valid(assembly);
  const double checked_ratio = contact::given_stiffness_ratio(ratio);
  for (Contact& c : assembly.contacts) {
    const double radius = contact::pair_radius(assembly.radius[c.i], assembly.radius[c.j]);
    assign(c, law.of(law.grain(), radius), checked_ratio, from);
  }
  for (Contact& c : assembly.wall_contacts)
    assign_wall(c, law.of(law.grain(), assembly.radius[c.i]), checked_ratio, from);
}

void assign_hertz_stiffness(Assembly& assembly, const contact::GrainMaterial& grain, double ratio,
                            StiffnessFrom from) {
  constexpr double any_radius = 1; // each pair has its own
  assign_stiffness_by_size(assembly, contact::PowerLaw::sphere(grain, any_radius), ratio, from);
}

namespace {

/// Calls `pair` for each contact, `wall` for each with a wall, with the material of its two grains, their
/// pair_radius and k_t/k_n.
template <class Pair, class Wall>
void assign_of_materials(Assembly& assembly, std::span<const contact::GrainMaterial> materials,
                         std::optional<double> ratio, const Pair& pair, const Wall& wall) {
  require_valid(assembly);
  require_materials(assembly, materials);
  const auto ratio_of = [&](const contact::GrainMaterial& grain) {
    return ratio ? contact::given_stiffness_ratio(*ratio)
                 : contact::mindlin_stiffness_ratio(grain.poisson_ratio);
  };
  for (Contact& c : assembly.contacts) {
    const contact::GrainMaterial grain = contact::pair_material(materials[c.i], materials[c.j]);
    pair(c, grain, contact::pair_radius(assembly.radius[c.i], assembly.radius[c.j]), ratio_of(grain));
  }
  for (Contact& c : assembly.wall_contacts)
    wall(c, materials[c.i], assembly.radius[c.i], ratio_of(materials[c.i]));
}

} // namespace

void assign_hertz_stiffness(Assembly& assembly, std::span<const contact::GrainMaterial> materials,
                            std::optional<double> ratio, StiffnessFrom from) {
  const auto assign_with = [from](const auto& function) {
    return [=](Contact& c, const contact::GrainMaterial& grain, double radius, double k_ratio) {
      function(c, contact::PowerLaw::sphere(grain, radius), k_ratio, from);
    };
  };
  assign_of_materials(assembly, materials, ratio, assign_with(&assign), assign_with(&assign_wall));
}

void assign_adhesive_stiffness(Assembly& assembly, const contact::Adhesion& adhesion,
                               std::span<const contact::GrainMaterial> materials, std::optional<double> ratio,
                               StiffnessFrom from) {
  if (from == StiffnessFrom::ratio)
    throw InvalidArgument("the stiffness of contacts with adhesion is not 1.5 f/d");
  const auto assign_with = [&](double copies) { // 2 at a wall: the overlap with the mirror image
    return [=](Contact& c, const contact::GrainMaterial& grain, double radius, double k_ratio) {
      const contact::AdhesiveContact state =
          from == StiffnessFrom::overlap
              ? adhesive_contact_at_overlap(adhesion, grain, radius, copies * c.overlap)
              : adhesive_contact_at_force(adhesion, grain, radius, c.normal_force);
      c.normal_stiffness = copies * state.stiffness;
      c.tangential_stiffness = k_ratio * copies * state.hertz_stiffness;
    };
  };
  assign_of_materials(assembly, materials, ratio, assign_with(1), assign_with(2));
}

void assign_stiffness_of_ratio(Assembly& assembly, double ratio) {
  require_valid(assembly);
  const double checked_ratio = contact::given_stiffness_ratio(ratio);
  for (auto* contacts : {&assembly.contacts, &assembly.wall_contacts})
    for (Contact& c : *contacts) {
      const bool presses = c.overlap > 0 && c.normal_force > 0;
      c.normal_stiffness = presses ? 1.5 * c.normal_force / c.overlap : 0;
      c.tangential_stiffness = checked_ratio * c.normal_stiffness;
    }
}

namespace {

double turning_stiffness(const TurningSpring& spring, const Contact& c, double reduced_radius) {
  switch (spring.of) {
  case TurningSpring::Of::angle:
    return spring.value;
  case TurningSpring::Of::displacement:
    return spring.value * reduced_radius * reduced_radius;
  case TurningSpring::Of::normal:
    return spring.value * c.normal_stiffness * reduced_radius * reduced_radius;
  case TurningSpring::Of::marshall: // a^2 = R* d
    return c.tangential_stiffness * reduced_radius * std::max(c.overlap, 0.0) / 2;
  }
  return 0;
}

void assign_turning(Assembly& assembly, const TurningSpring& spring, double Contact::*stiffness) {
  require_valid(assembly);
  require_non_negative("turning stiffness", spring.value);
  for (Contact& c : assembly.contacts) {
    const double r_i = assembly.radius[c.i], r_j = assembly.radius[c.j];
    c.*stiffness = turning_stiffness(spring, c, r_i * r_j / (r_i + r_j));
  }
  for (Contact& c : assembly.wall_contacts)
    c.*stiffness = turning_stiffness(spring, c, assembly.radius[c.i]);
}

} // namespace

void assign_rolling_stiffness(Assembly& assembly, const TurningSpring& spring) {
  assign_turning(assembly, spring, &Contact::rolling_stiffness);
}

void assign_twisting_stiffness(Assembly& assembly, const TurningSpring& spring) {
  assign_turning(assembly, spring, &Contact::twisting_stiffness);
}

} // namespace granum::packing
