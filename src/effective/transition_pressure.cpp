// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/transition_pressure.hpp>

#include <algorithm>
#include <cmath>

#include <granum/core/error.hpp>

#include "checked_state.hpp"
#include "core/root.hpp"

namespace granum::effective {

std::optional<double> transition_pressure(const State& state) {
  const auto geometry = kernel::checked_geometry(state);
  kernel::require_contacts(state);
  const contact::RoughSphere* const law = state.law.rough_sphere();
  if (law == nullptr)
    return std::nullopt;
  return law->transition_force() / (3 * geometry.force_area);
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
