// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/model.hpp>

#include <granum/core/error.hpp>

#include "checked_state.hpp"
#include "stress_derivatives.hpp"

namespace granum::effective {

namespace {

elastic::TransverselyIsotropic of_contacts(const UniformContacts& contacts, Hypothesis hypothesis) {
  switch (hypothesis) {
  case Hypothesis::uniform_strain:
    return uniform_strain_stiffness(contacts);
  case Hypothesis::free_spin:
    return free_spin_stiffness(contacts);
  case Hypothesis::uniform_stress:
    return uniform_stress_stiffness(contacts);
  }
  throw InvalidArgument("hypothesis is not one of the known ones");
}

Estimate by_direction(const State& state, Hypothesis hypothesis) {
  switch (hypothesis) {
  case Hypothesis::uniform_strain:
    return uniform_strain(state);
  case Hypothesis::free_spin:
    return free_spin(state);
  case Hypothesis::uniform_stress:
    return uniform_stress(state);
  }
  throw InvalidArgument("hypothesis is not one of the known ones");
}

/// All contacts stiffen alike, so every modulus that does not vanish has the same exponents.
StressExponents at_mean_force(const State& state, const Model& model, Modulus which) {
  kernel::require_differentiable(state, model.hypothesis, which);
  const elastic::TransverselyIsotropic stiffness = uniform_field(state, model).stiffness;
  kernel::require_modulus(modulus(stiffness, which), stiffness.C11, which);
  const double share_v = state.stress_v / (state.stress_v + 2 * state.stress_h);
  const double b = kernel::local_exponent(state);
  return {.stress_v = b * share_v, .stress_h = b * (1 - share_v)};
}

} // namespace

Estimate uniform_field(const State& state, const Model& model) {
  if (model.forces == ContactForces::by_direction)
    return by_direction(state, model.hypothesis);
  Estimate estimate{.stiffness = {}, .validity = kernel::checked(state).validity};
  if (*state.coordination_number > 0)
    estimate.stiffness = of_contacts(uniform_contacts(state), model.hypothesis);
  return estimate;
}

StressExponents uniform_field_exponents(const State& state, const Model& model, Modulus which) {
  if (model.forces == ContactForces::mean)
    return at_mean_force(state, model, which);
  kernel::require_differentiable(state, model.hypothesis, which);
  return kernel::exponents_of(kernel::stress_derivatives(state, model), which);
}

} // namespace granum::effective
