// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/effective/exponents.hpp>
#include <granum/effective/state.hpp>
#include <granum/effective/uniform_field.hpp>

/// The uniform-field estimates by name: how the grains move, and which force sets the contact stiffness.
namespace granum::effective {

/// How the grains are assumed to move.
enum class Hypothesis {
  uniform_strain, ///< follow the mean strain, no spin
  free_spin,      ///< follow the mean strain, share the spin of least energy
  uniform_stress  ///< carry the forces of the mean stress
};

/// Which force sets the stiffness of a contact.
enum class ContactForces {
  mean,        ///< the mean force of all contacts: rungs 0 and 1, uniform_contacts(state)
  by_direction ///< the static force field: rung 2, uniform_strain(state), free_spin, uniform_stress
};

struct Model {
  Hypothesis hypothesis = Hypothesis::uniform_strain;
  ContactForces forces = ContactForces::by_direction;
};

/// The stiffness of a model: uniform_strain, free_spin or uniform_stress of the state or of
/// uniform_contacts(state).
/// Without contacts (C_n = 0): 0.
/// \throws   InvalidArgument as require_valid(State)
/// Accuracy  as the functions named.  Checked by tests/effective/test_rungs.cpp
[[nodiscard]] Estimate uniform_field(const State& state, const Model& model);

/// Exponents of a modulus of uniform_field(state, model). If all contacts have the stiffness at the mean
/// force, they stiffen with the mean stress alone: every modulus grows as p^b, b = contact_exponent(state),
/// and b is split between stress_v and stress_h in the ratio stress_v : 2 stress_h.
/// \throws   InvalidArgument as uniform_strain_exponents
/// Accuracy  1e-12 absolute.  Checked by tests/effective/test_rungs.cpp
[[nodiscard]] StressExponents uniform_field_exponents(const State& state, const Model& model, Modulus which);

} // namespace granum::effective
