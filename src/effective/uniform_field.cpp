// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/uniform_field.hpp>

#include <cmath>

#include <granum/core/check.hpp>
#include <granum/core/error.hpp>
#include <granum/fabric/orientation.hpp>

#include "kernels.hpp"

namespace granum::effective {

namespace {

using kernel::AxialMoments;

elastic::TransverselyIsotropic transversely_isotropic(const kernel::Constants<double>& c) {
  return {.C11 = c.C11, .C33 = c.C33, .C12 = c.C12, .C13 = c.C13, .C44 = c.C44};
}

/// Moments of the weight 1.
AxialMoments<double> fabric_moments(double anisotropy) {
  return {
      .m0 = 1, .m2 = fabric::second_moments(anisotropy).F33, .m4 = fabric::fourth_moments(anisotropy).n3333};
}

/// Stiffness ratios of the contacts over direction, to be multiplied by one stiffness.
struct ContactStiffness {
  double reference = 0;         ///< k_ref [N/m]
  AxialMoments<double> moments; ///< of (k_n/k_ref)^sign
};

ContactStiffness contact_stiffness(const State& s, double sign) {
  const StaticForceField field = kernel::static_force_field(s, fabric::second_moments(s.fabric_anisotropy));
  const double b = s.law.stiffness_exponent();
  if (field.horizontal == field.vertical || b == 0)
    return {s.law.stiffness_at_force(field.vertical), fabric_moments(s.fabric_anisotropy)};
  return {s.law.stiffness_at_force(std::sqrt(field.horizontal) * std::sqrt(field.vertical)),
          kernel::stiffness_moments(s.fabric_anisotropy, field, b, sign)};
}

/// Where the density of contacts is negative the sums over them may lose their sign too.
void note_instability(const State& s, const elastic::TransverselyIsotropic& c, Validity& validity) {
  if (std::abs(s.fabric_anisotropy) > 1 && !c.positive_definite())
    validity.add(
        "the stiffness is not positive definite: this fabric anisotropy cannot be used at these stresses");
}

struct CheckedContacts {
  double scale;
  double ratio;
};

CheckedContacts checked(const UniformContacts& c) {
  require_positive("prefactor", c.prefactor, "1/m");
  require_non_negative("normal_stiffness", c.normal_stiffness, "N/m");
  require_non_negative("tangential_stiffness", c.tangential_stiffness, "N/m");
  require_open("fabric_anisotropy", c.fabric_anisotropy, -7.0 / 3, 7.0 / 5);
  if (c.normal_stiffness == 0) {
    require_closed("tangential_stiffness", c.tangential_stiffness, 0, 0, "N/m");
    return {0, 0};
  }
  return {c.prefactor * c.normal_stiffness, c.tangential_stiffness / c.normal_stiffness};
}

} // namespace

elastic::TransverselyIsotropic uniform_strain_stiffness(const UniformContacts& contacts) {
  const auto [scale, ratio] = checked(contacts);
  return transversely_isotropic(
      kernel::uniform_strain(scale, ratio, fabric_moments(contacts.fabric_anisotropy)));
}

elastic::TransverselyIsotropic uniform_stress_stiffness(const UniformContacts& contacts) {
  const auto [scale, ratio] = checked(contacts);
  const double a = contacts.fabric_anisotropy;
  return transversely_isotropic(
      kernel::uniform_stress(scale, ratio, fabric::second_moments(a), fabric_moments(a)));
}

UniformContacts uniform_contacts(const State& state) {
  const double stiffness = state.law.stiffness_at_force(mean_contact_force(state));
  return {.prefactor = kernel::prefactor(state),
          .normal_stiffness = stiffness,
          .tangential_stiffness = state.tangential_ratio * stiffness,
          .fabric_anisotropy = state.fabric_anisotropy};
}

Estimate uniform_strain(const State& state) {
  Estimate estimate{.stiffness = {}, .validity = require_valid(state)};
  const auto [reference, moments] = contact_stiffness(state, 1);
  const double scale = kernel::prefactor(state) * reference;
  estimate.stiffness = transversely_isotropic(kernel::uniform_strain(scale, state.tangential_ratio, moments));
  note_instability(state, estimate.stiffness, estimate.validity);
  return estimate;
}

Estimate uniform_stress(const State& state) {
  Estimate estimate{.stiffness = {}, .validity = require_valid(state)};
  const auto [reference, moments] = contact_stiffness(state, -1);
  const double scale = kernel::prefactor(state) * reference;
  const fabric::SecondMoments F = fabric::second_moments(state.fabric_anisotropy);
  estimate.stiffness =
      transversely_isotropic(kernel::uniform_stress(scale, state.tangential_ratio, F, moments));
  note_instability(state, estimate.stiffness, estimate.validity);
  if (state.tangential_ratio == 0)
    estimate.validity.add(
        "uniform stress without tangential stiffness gives zero shear moduli: its force field "
        "lets every contact slide");
  return estimate;
}

} // namespace granum::effective
