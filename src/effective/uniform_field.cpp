// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/uniform_field.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <granum/core/error.hpp>

#include "checked_state.hpp"

namespace granum::effective {

namespace {

using elastic::TransverselyIsotropic;
using kernel::AxialMoments;
using kernel::Spin;

TransverselyIsotropic transversely_isotropic(const kernel::Constants<double>& c) {
  return {.C11 = c.C11, .C33 = c.C33, .C12 = c.C12, .C13 = c.C13, .C44 = c.C44};
}

/// Means of (k_n/k_ref)^sign over the directions, sign = 1 or -1.
AxialMoments<double> contact_moments(const State& s, const kernel::CheckedState& checked, double sign) {
  const kernel::NormalLoads<double>& loads = checked.loads;
  const std::optional<double> b = s.law.constant_exponent();
  if (loads.horizontal == loads.vertical || b == 0.0)
    return kernel::fabric_moments(s.fabric_anisotropy);
  const double ratio = loads.horizontal / loads.vertical;
  const double root = std::sqrt(ratio);
  const auto moments = [&](const auto& weight) {
    return kernel::direction_moments(s.fabric_anisotropy, root, 1 / root, root, weight,
                                     kernel::rule_for(ratio));
  };
  if (b)
    return moments([exponent = sign * *b](double f) { return kernel::power(f, exponent); });
  const double mean = std::sqrt(loads.horizontal) * std::sqrt(loads.vertical);
  return moments(kernel::StiffnessRatio<double>{.law = s.law,
                                                .reference = checked.geometry.force_area * mean,
                                                .stiffness = checked.stiffness,
                                                .inverse = sign < 0});
}

/// Where the density of contacts is negative, sums over the contacts may become negative too.
void note_instability(const State& s, Estimate& estimate) {
  if (std::abs(s.fabric_anisotropy) > 1 && !estimate.stiffness.positive_definite())
    estimate.validity.add(
        "the stiffness is not positive definite: this fabric anisotropy cannot be used at these stresses");
}

Estimate strained(const State& state, Spin spin) {
  kernel::CheckedState checked = kernel::checked(state);
  const double scale = checked.geometry.prefactor * checked.stiffness;
  const auto moments = contact_moments(state, checked, 1);
  Estimate estimate{.stiffness = transversely_isotropic(
                        kernel::uniform_strain(scale, state.tangential_ratio, moments, spin)),
                    .validity = std::move(checked.validity)};
  note_instability(state, estimate);
  return estimate;
}

struct CheckedContacts {
  double scale;
  double ratio;
};

CheckedContacts checked(const UniformContacts& c) {
  require_positive("prefactor", c.prefactor, "1/m");
  require_non_negative("normal_stiffness", c.normal_stiffness, "N/m");
  require_closed("tangential_stiffness", c.tangential_stiffness, 0,
                 kernel::largest_tangential_ratio * c.normal_stiffness, "N/m");
  require_open("fabric_anisotropy", c.fabric_anisotropy, -7.0 / 3, 7.0 / 5);
  if (!(c.branch_evenness > 0 && c.branch_evenness <= 1))
    throw InvalidArgument("branch_evenness", c.branch_evenness, "", "(0, 1]");
  if (c.normal_stiffness == 0)
    return {0, 0};
  return {c.prefactor * c.normal_stiffness, c.tangential_stiffness / c.normal_stiffness};
}

TransverselyIsotropic strained(const UniformContacts& contacts, Spin spin) {
  const auto [scale, ratio] = checked(contacts);
  return transversely_isotropic(
      kernel::uniform_strain(scale, ratio, kernel::fabric_moments(contacts.fabric_anisotropy), spin));
}

} // namespace

TransverselyIsotropic uniform_strain_stiffness(const UniformContacts& contacts) {
  return strained(contacts, Spin::none);
}

TransverselyIsotropic free_spin_stiffness(const UniformContacts& contacts) {
  return strained(contacts, Spin::free);
}

TransverselyIsotropic uniform_stress_stiffness(const UniformContacts& contacts) {
  const auto [scale, ratio] = checked(contacts);
  const auto moments = kernel::fabric_moments(contacts.fabric_anisotropy);
  return transversely_isotropic(
      kernel::uniform_stress(scale * contacts.branch_evenness, ratio, moments, moments));
}

UniformContacts uniform_contacts(const State& state) {
  const auto geometry = kernel::checked_geometry(state);
  kernel::require_contacts(state);
  const double stiffness =
      kernel::contact_stiffness(state.law, geometry.force_area, state.stress_v + 2 * state.stress_h);
  return {.prefactor = geometry.prefactor,
          .normal_stiffness = stiffness,
          .tangential_stiffness = state.tangential_ratio * stiffness,
          .fabric_anisotropy = state.fabric_anisotropy,
          .branch_evenness = std::min(1.0, state.contacts.branch * state.contacts.branch /
                                               state.contacts.branch_square)}; // but for rounding
}

Estimate uniform_strain(const State& state) { return strained(state, Spin::none); }

Estimate free_spin(const State& state) { return strained(state, Spin::free); }

Estimate uniform_stress(const State& state) {
  kernel::CheckedState checked = kernel::checked(state);
  const double scale = checked.geometry.static_prefactor * checked.stiffness;
  const auto moments = contact_moments(state, checked, -1);
  const auto fabric = kernel::fabric_moments(state.fabric_anisotropy);
  Estimate estimate{.stiffness = transversely_isotropic(
                        kernel::uniform_stress(scale, state.tangential_ratio, fabric, moments)),
                    .validity = std::move(checked.validity)};
  note_instability(state, estimate);
  if (state.tangential_ratio == 0)
    estimate.validity.add(
        "uniform stress without tangential stiffness gives zero shear moduli: its force field "
        "lets every contact slide");
  return estimate;
}

IsotropicModuli uniform_strain_moduli(const IsotropicPacking& packing) {
  const double r = require_non_negative("tangential_ratio", packing.tangential_ratio);
  require_positive("radius", packing.radius, "m");
  require_positive("void_ratio", packing.void_ratio);
  require_non_negative("coordination_number", packing.coordination_number);
  require_non_negative("pressure", packing.pressure, "Pa");
  sizes::require_valid(packing.contacts);
  if (packing.coordination_number == 0)
    return {};
  const auto geometry =
      kernel::geometry(packing.coordination_number, packing.radius, packing.void_ratio, packing.contacts);
  const double scale =
      geometry.prefactor * kernel::contact_stiffness(packing.law, geometry.force_area, 3 * packing.pressure);
  return {.bulk_modulus = scale / 9, .shear_modulus = scale * (2 + 3 * r) / 30};
}

} // namespace granum::effective
