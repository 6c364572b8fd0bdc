// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/effective/exponents.hpp>
#include <granum/effective/state.hpp>
#include <granum/effective/uniform_field.hpp>

/// The uniform-field estimates by name: what the grains do, and which force makes a contact stiff.
namespace granum::effective {

/// What the grains are taken to do.
enum class Hypothesis {
  uniform_strain, ///< follow the mean strain, no spin
  free_spin,      ///< follow the mean strain, spin alike as the energy likes best
  uniform_stress  ///< carry the forces of the mean stress
};

/// Which force sets the stiffness of a contact.
enum class ContactForces {
  mean,        ///< the mean force of all contacts: rungs 0 and 1, uniform_contacts(state)
  by_direction ///< the static force field: rung 2, uniform_strain(state) and its kin
};

struct Model {
  Hypothesis hypothesis = Hypothesis::uniform_strain;
  ContactForces forces = ContactForces::by_direction;
};

/// The stiffness of a model: uniform_strain(state) and its kin, or the same of uniform_contacts(state).
/// Without contacts (C_n = 0): 0.
/// \throws   InvalidArgument as require_valid(State)
/// Accuracy  as the functions named.  Checked by tests/effective/test_rungs.cpp
[[nodiscard]] Estimate uniform_field(const State& state, const Model& model);

/// Exponents of a modulus of uniform_field(state, model). Contacts of one stiffness, that of the mean force,
/// stiffen with the mean stress alone: every modulus goes as p^b, b = contact_exponent(state), and stress_v
/// and stress_h share b as stress_v and 2 stress_h share 3 p.
/// \throws   InvalidArgument as uniform_strain_exponents
/// Accuracy  1e-12 absolute.  Checked by tests/effective/test_rungs.cpp
[[nodiscard]] StressExponents uniform_field_exponents(const State& state, const Model& model, Modulus which);

} // namespace granum::effective
