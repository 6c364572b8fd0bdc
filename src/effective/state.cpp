// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/state.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include <granum/core/check.hpp>
#include <granum/core/error.hpp>
#include <granum/fabric/orientation.hpp>

#include "kernels.hpp"

namespace granum::effective {

namespace {

constexpr double largest_force_ratio = 1e4;

void require_stresses(const State& s, const StaticForceField& field) {
  if (s.stress_v == 0 && s.stress_h == 0)
    return;
  require_positive("stress_v", s.stress_v, "Pa");
  require_positive("stress_h", s.stress_h, "Pa");
  const double ratio = field.vertical / field.horizontal;
  if (!(ratio <= largest_force_ratio && ratio >= 1 / largest_force_ratio))
    throw InvalidArgument("ratio of vertical to horizontal contact forces", ratio, "", "[1e-4, 1e4]");
}

void note_contact_size(const State& s, const StaticForceField& field, Validity& validity) {
  const double force = std::max(field.horizontal, field.vertical);
  const auto& grain = s.law.grain();
  const double contact_radius =
      s.law.stiffness_at_force(force) * (1 - grain.poisson_ratio) / (2 * grain.shear_modulus);
  if (contact_radius > 0.1 * s.radius) {
    char text[160];
    std::snprintf(text, sizeof text,
                  "contact radius is %.3g grain radii: contact laws are derived for contacts that are small "
                  "against the grain (0.1)",
                  contact_radius / s.radius);
    validity.add(text);
  }
}

} // namespace

Validity require_valid(const State& s) {
  require_non_negative("tangential_ratio", s.tangential_ratio);
  require_positive("radius", s.radius, "m");
  require_positive("void_ratio", s.void_ratio);
  require_positive("coordination_number", s.coordination_number);
  require_open("fabric_anisotropy", s.fabric_anisotropy, -7.0 / 3, 7.0 / 5);
  require_non_negative("stress_v", s.stress_v, "Pa");
  require_non_negative("stress_h", s.stress_h, "Pa");
  const StaticForceField field = kernel::static_force_field(s, fabric::second_moments(s.fabric_anisotropy));
  require_stresses(s, field);

  Validity validity = fabric::anisotropy_validity(s.fabric_anisotropy);
  if (s.coordination_number > 12)
    validity.add("coordination number exceeds 12, the most that equal spheres can have");
  note_contact_size(s, field, validity);
  return validity;
}

double prefactor(const State& state) {
  require_valid(state);
  return kernel::prefactor(state);
}

double mean_contact_force(const State& state) {
  require_valid(state);
  return 2 * state.radius * (state.stress_v + 2 * state.stress_h) / kernel::prefactor(state);
}

double StaticForceField::tangential_force(double n3) const {
  return (horizontal - vertical) * n3 * std::sqrt((1 - n3) * (1 + n3));
}

double StaticForceField::mobilised_friction() const {
  return vertical == horizontal ? 0
                                : std::abs(vertical - horizontal) / (2 * std::sqrt(vertical * horizontal));
}

StaticForceField static_force_field(const State& state) {
  require_valid(state);
  return kernel::static_force_field(state, fabric::second_moments(state.fabric_anisotropy));
}

} // namespace granum::effective
