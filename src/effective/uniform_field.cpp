// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/uniform_field.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <granum/core/error.hpp>
#include <granum/stress/stress.hpp>

#include "core/root.hpp"
#include "kernels.hpp"
#include "mixture_kernel.hpp"

namespace granum::effective {

namespace {

using elastic::TransverselyIsotropic;
using kernel::AxialMoments;
using kernel::Spin;

TransverselyIsotropic transversely_isotropic(const kernel::Constants<double>& c) {
  return {.C11 = c.C11, .C33 = c.C33, .C12 = c.C12, .C13 = c.C13, .C44 = c.C44};
}

/// What grains of several materials leave of uniform stress, in which every contact has its force: the
/// harmonic mean of their stiffnesses over the mean.
double share_under_stress(const State& s) {
  return s.pair_shares.empty() ? 1 : kernel::medium_of(s.pair_shares, 1).stiffness;
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
          .branch_evenness = share_under_stress(state) *
                             std::min(1.0, state.contacts.branch * state.contacts.branch /
                                               state.contacts.branch_square)}; // but for rounding
}

Estimate uniform_strain(const State& state) { return strained(state, Spin::none); }

Estimate free_spin(const State& state) { return strained(state, Spin::free); }

Estimate uniform_stress(const State& state) {
  kernel::CheckedState checked = kernel::checked(state);
  const double scale = checked.geometry.static_prefactor * checked.stiffness * share_under_stress(state);
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

// Contacts that have been loaded in proportion respond by f = alpha/(1+alpha) (k_n d_n n + k_t d_t), so that
// stress = alpha/(1+alpha) C strain with the tangent stiffness C of the same contacts: the kernel of uniform
// strain serves for both. The law is homogeneous, and the ratio of the strains, exp(t), is the one unknown.

namespace {

using kernel::AxialMoments;

/// Strains exp(t/2) along the axis and exp(-t/2) across, t = ln(strain_v/strain_h).
const double largest_t = std::log(1e4);

/// The only unknown of a homogeneous law.
const contact::PowerLaw& power_law(const State& s) {
  return kernel::power_law_of(s, "the field of a uniform strain from no load");
}

/// Moments of (k_n/k_ref)^sign at such strains, k_ref that of an overlap of l times strain 1.
AxialMoments<double> strain_moments(const State& s, double t, double sign) {
  const double exponent = sign / power_law(s).alpha(); // k_n ~ d^(1/alpha)
  if (exponent == 0 || t == 0)
    return kernel::fabric_moments(s.fabric_anisotropy);
  const double root = std::exp(-t / 2);
  const auto power = [exponent](double d) { return kernel::power(d, exponent); };
  return kernel::direction_moments(s.fabric_anisotropy, root, 1 / root, root, power,
                                   kernel::rule_for(root * root));
}

/// Stresses over P/l c (l strain)^(1+1/alpha).
stress::AxialStress stresses_at(const State& s, double t) {
  const auto c = kernel::uniform_strain(1.0, s.tangential_ratio, strain_moments(s, t, 1), kernel::Spin::none);
  const double v = std::exp(t / 2), h = std::exp(-t / 2);
  return {.v = c.C33 * v + 2 * c.C13 * h, .h = (c.C11 + c.C12) * h + c.C13 * v};
}

[[noreturn]] void refuse(const State& s) {
  const auto ratio = [&](double t) {
    const stress::AxialStress stress = stresses_at(s, t);
    return stress.v / stress.h;
  };
  const double low = ratio(-largest_t), high = ratio(largest_t);
  const auto bound = [](double x) { return x > 0 ? std::to_string(x) : std::string("0"); };
  throw InvalidArgument("stress_v/stress_h", s.stress_v / s.stress_h, "",
                        "(" + bound(low) + ", " + (high > 0 ? std::to_string(high) : "inf") +
                            "), beyond which a uniform strain opens contacts");
}

/// The ratio of strains whose stresses have the stress ratio of the state.
double strain_ratio(const State& s) {
  const double share = s.stress_v / (s.stress_v + s.stress_h);
  const auto excess = [&](double t) { // grows with t, of order 1 where both stresses are positive
    const stress::AxialStress stress = stresses_at(s, t);
    return ((1 - share) * stress.v - share * stress.h) / (std::abs(stress.v) + std::abs(stress.h));
  };
  const double low = excess(-largest_t), high = excess(largest_t);
  if (!(low < 0 && high > 0))
    refuse(s);
  return middle(root_between(excess, -largest_t, largest_t, low, high, within_bits(52)));
}

/// The strains exp(t/2) and exp(-t/2), scaled so that a contact reaches the force force_area load.
struct Solution {
  double t = 0;
  double load = 0; ///< [Pa]
};

Solution solve(const State& s) {
  if (s.stress_v == 0)
    return {};
  const double t = strain_ratio(s);
  const stress::AxialStress stress = stresses_at(s, t);
  return {.t = t, .load = (s.stress_v + 2 * s.stress_h) / (stress.v + 2 * stress.h)};
}

struct Field {
  kernel::CheckedState checked;
  Solution solution;
  double stiffness = 0; ///< k_ref
};

/// l for which the stress of the field (forces independent of branch length) agrees with its stiffness:
/// N_c <l> f(l strain)/V = alpha/(1+alpha) N_c <l^2>/V k_n strain.
double branch_length(const State& s) { return 2 * s.radius * (s.contacts.branch_square / s.contacts.branch); }

Field field(const State& s) {
  Field field{.checked = kernel::checked(s), .solution = {}};
  if (s.coordination_number == 0)
    return field;
  field.solution = solve(s);
  field.stiffness = kernel::contact_stiffness(s.law, field.checked.geometry.force_area, field.solution.load);
  return field;
}

Estimate estimate(Field&& field, const kernel::Constants<double>& c) {
  return {.stiffness = {.C11 = c.C11, .C33 = c.C33, .C12 = c.C12, .C13 = c.C13, .C44 = c.C44},
          .validity = std::move(field.checked.validity)};
}

} // namespace

double KinematicForceField::overlap(double n3) const {
  return branch_length * (strain_h * (1 - n3) * (1 + n3) + strain_v * n3 * n3);
}

double KinematicForceField::tangential_force(double n3) const {
  const double slide = branch_length * (strain_h - strain_v) * n3 * std::sqrt((1 - n3) * (1 + n3));
  return tangential_ratio * law.stiffness_at_overlap(overlap(n3)) / law.force_exponent() * slide;
}

KinematicForceField kinematic_force_field(const State& s) {
  const auto checked = kernel::checked(s);
  kernel::require_contacts(s);
  const Solution solution = solve(s);
  const double length = branch_length(s);
  const double strain = s.law.overlap(checked.geometry.force_area * solution.load) / length;
  return {.law = power_law(s),
          .tangential_ratio = s.tangential_ratio,
          .branch_length = length,
          .strain_v = strain * std::exp(solution.t / 2),
          .strain_h = strain * std::exp(-solution.t / 2)};
}

Estimate uniform_strain_kinematic(const State& s) {
  Field f = field(s);
  const auto moments = strain_moments(s, f.solution.t, 1);
  const double scale = f.checked.geometry.prefactor * f.stiffness;
  return estimate(std::move(f),
                  kernel::uniform_strain(scale, s.tangential_ratio, moments, kernel::Spin::none));
}

Estimate uniform_stress_kinematic(const State& s) {
  Field f = field(s);
  const auto moments = strain_moments(s, f.solution.t, -1);
  const auto fabric = kernel::fabric_moments(s.fabric_anisotropy);
  const double scale = f.checked.geometry.static_prefactor * f.stiffness * share_under_stress(s);
  return estimate(std::move(f), kernel::uniform_stress(scale, s.tangential_ratio, fabric, moments));
}

} // namespace granum::effective
