// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/state.hpp>

#include <algorithm>
#include <cmath>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/fabric/orientation.hpp>

#include "core/root.hpp"
#include "kernels.hpp"
#include "mixture_kernel.hpp"

namespace granum::effective {

namespace {

constexpr double largest_force_ratio = 1e4;
constexpr double largest_contact_radius = 0.1; // of the grain radius

[[gnu::noinline]] void require_possible(const Unevenness& forces) {
  constexpr double largest = 1; // k_n of every contact nearly three times the mean
  require_closed("unevenness", forces.value, -largest, largest);
  require_non_negative("standard error of the unevenness", forces.standard_error);
  require_finite("slope of the unevenness", forces.by_pressure);
}

/// Inlined in both of its callers: a call would cost a tenth of rung 0.
[[gnu::always_inline]] inline void require_members(const State& s) {
  require_closed("tangential_ratio", s.tangential_ratio, 0, kernel::largest_tangential_ratio);
  require_positive("radius", s.radius, "m");
  sizes::require_valid(s.contacts);
  require_positive("void_ratio", s.void_ratio);
  if (s.coordination_number)
    require_non_negative("coordination_number", *s.coordination_number);
  if (s.mechanical_coordination_number)
    require_non_negative("mechanical_coordination_number", *s.mechanical_coordination_number);
  require_open("fabric_anisotropy", s.fabric_anisotropy, -7.0 / 3, 7.0 / 5);
  require_non_negative("stress_v", s.stress_v, "Pa");
  require_non_negative("stress_h", s.stress_h, "Pa");
  require_closed("rolling", s.rolling, 0, 1);
  if (s.unevenness)
    require_possible(*s.unevenness);
  if (!s.pair_shares.empty())
    kernel::require_relative(s.pair_shares);
  if (s.stress_v == 0 && s.stress_h == 0)
    return;
  require_positive("stress_v", s.stress_v, "Pa");
  require_positive("stress_h", s.stress_h, "Pa");
  const double ratio = s.stress_v / s.stress_h * ((5 - 3 * s.fabric_anisotropy) / (5 + s.fabric_anisotropy));
  if (!(ratio <= largest_force_ratio && ratio >= 1 / largest_force_ratio))
    throw InvalidArgument("ratio of vertical to horizontal contact forces", ratio, "", "[1e-4, 1e4]");
}

void require_known_contacts(const State& s) {
  if (!s.coordination_number)
    throw InvalidArgument("coordination_number is missing: this closed form needs the number of contacts");
}

void note_contact_size(const State& s, double stiffness, Validity& validity) {
  const auto& grain = s.law.grain();
  const double contact_radius = stiffness * (1 - grain.poisson_ratio) / (2 * grain.shear_modulus);
  const double grain_radius = s.radius * s.contacts.pair_radius;
  if (contact_radius > largest_contact_radius * grain_radius)
    validity.add(
        detail::formatted("contact radius is %.3g grain radii: contact laws are derived for contacts "
                          "that are small against the grain (0.1)",
                          contact_radius / grain_radius));
}

} // namespace

namespace kernel {

Geometry<double> checked_geometry(const State& s) {
  require_known_contacts(s);
  require_members(s);
  return geometry(s);
}

CheckedState checked(const State& s) {
  require_known_contacts(s);
  require_members(s);
  CheckedState state{.geometry = geometry(s),
                     .loads = static_loads(s.fabric_anisotropy, s.stress_v, s.stress_h),
                     .stiffness = 0,
                     .validity = {}};
  if (std::abs(s.fabric_anisotropy) > 1)
    state.validity = fabric::anisotropy_validity(s.fabric_anisotropy);
  if (*s.coordination_number == 0) {
    state.validity.add("a packing without contacts carries no stress: its stiffness is the limit 0");
    return state;
  }
  if (*s.coordination_number > 12)
    state.validity.add("coordination number exceeds 12, the most that equal spheres can have");

  const auto [horizontal, vertical] = state.loads;
  const bool uniform = horizontal == vertical;
  const double mean = uniform ? vertical : std::sqrt(horizontal) * std::sqrt(vertical);
  const double largest = std::max(horizontal, vertical);
  state.stiffness = contact_stiffness(s.law, state.geometry.force_area, mean);
  // k_n grows with a power of the force that is at most 1: this bound settles almost every
  // state without the stiffness at the largest force.
  const double bound = uniform ? state.stiffness : state.stiffness * (largest / mean);
  if (bound * (1 - s.law.grain().poisson_ratio) >
      2 * s.law.grain().shear_modulus * largest_contact_radius * (s.radius * s.contacts.pair_radius))
    note_contact_size(s, contact_stiffness(s.law, state.geometry.force_area, largest), state.validity);
  return state;
}

void require_contacts(const State& state) {
  require_positive("coordination_number", state.coordination_number.value_or(0));
}

} // namespace kernel

Validity require_valid(const State& state) {
  if (state.coordination_number)
    return kernel::checked(state).validity;
  require_members(state);
  return {};
}

double prefactor(const State& state) { return kernel::checked_geometry(state).prefactor; }

double mean_contact_force(const State& state) {
  const auto geometry = kernel::checked_geometry(state);
  kernel::require_contacts(state);
  return geometry.force_area * (state.stress_v + 2 * state.stress_h);
}

double contact_exponent(const State& state) {
  (void)kernel::checked_geometry(state);
  return kernel::local_exponent(state);
}

double StaticForceField::tangential_force(double n3) const {
  return (horizontal - vertical) * n3 * std::sqrt((1 - n3) * (1 + n3));
}

double StaticForceField::mobilised_friction() const {
  return vertical == horizontal ? 0
                                : std::abs(vertical - horizontal) / (2 * std::sqrt(vertical * horizontal));
}

StaticForceField static_force_field(const State& state) {
  const auto checked = kernel::checked(state);
  kernel::require_contacts(state);
  const double area = checked.geometry.force_area;
  return {.horizontal = area * checked.loads.horizontal, .vertical = area * checked.loads.vertical};
}

std::optional<double> transition_pressure(const State& state) {
  const auto geometry = kernel::checked_geometry(state);
  kernel::require_contacts(state);
  const std::optional<double> force = state.law.surface().transition_force;
  return force ? std::optional(*force / (3 * geometry.force_area)) : std::nullopt;
}

double transition_pressure_of(double exponent, double mean_stress) {
  require_positive("mean_stress", mean_stress, "Pa");
  const auto excess = [exponent](double log_X) {
    return contact::rough_stiffness(std::exp(log_X)).exponent - exponent;
  };
  constexpr double widest = 30; // |ln X|: b is 1e-9 from an end there
  if (!(excess(-widest) < 0 && excess(widest) > 0))
    throw InvalidArgument("exponent", exponent, "", "(1/3, 1)");
  const auto [left, right] = root_between(excess, -widest, widest, within_bits(45), 100);
  return mean_stress * std::exp(0.75 * (left + right));
}

double roughness_of(State state, double transition) {
  require_positive("transition_pressure", transition, "Pa");
  const double some = std::min(state.radius, contact::RoughSphere::largest_roughness);
  state.law = contact::RoughSphere(state.law.grain(), state.radius, some);
  return some * std::pow(transition / *transition_pressure(state), 2.0 / 3);
}

} // namespace granum::effective
