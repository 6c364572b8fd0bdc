// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <granum/effective/state.hpp>
#include <granum/effective/uniform_field.hpp>
#include <granum/elastic/transverse_isotropic.hpp>

namespace granum::effective {

/// Moduli whose growth with stress is computed. G_vh = G_hv = C44, G_hh = C66.
enum class Modulus { K, G_hh, G_vh, E_v, E_h, C11, C33, C12, C13 };

/// Local exponents of a modulus X at a state of constant C_n, e and a. Of G_ij = const sigma_i^m sigma_j^n
/// the exponent m belongs to i: for G_hv, m = stress_h and n = stress_v; for G_vh, m = stress_v and
/// n = stress_h.
struct StressExponents {
  double stress_v = 0; ///< d ln X/d ln stress_v
  double stress_h = 0; ///< d ln X/d ln stress_h
  /// s = d ln X/d ln p at constant stress ratio; 1/(1+alpha) for every X.
  [[nodiscard]] double sum() const { return stress_v + stress_h; }
};

/// The modulus of that name [Pa].
/// \throws   InvalidArgument for a Young's modulus of a stiffness that is not positive definite
[[nodiscard]] double modulus(const elastic::TransverselyIsotropic& stiffness, Modulus which);
/// The same for any stiffness: Young's moduli according to elastic::young_modulus, empty where undefined.
[[nodiscard]] std::optional<double> modulus_if_any(const elastic::TransverselyIsotropic& stiffness,
                                                   Modulus which);

/// Exponents of a modulus of uniform_strain(state), differentiated exactly under the integral.    [Chung2014]
/// \throws   InvalidArgument as require_valid(State), without stress or contacts, and where the modulus is
///           zero, as C12 and C13 at k_t = k_n
/// Accuracy  1e-12 absolute.  Checked by tests/effective/test_exponents.cpp
[[nodiscard]] StressExponents uniform_strain_exponents(const State& state, Modulus which);

/// Exponents of a modulus of free_spin(state).
/// \throws   InvalidArgument as uniform_strain_exponents
/// Accuracy  1e-12 absolute.  Checked by tests/effective/test_exponents.cpp
[[nodiscard]] StressExponents free_spin_exponents(const State& state, Modulus which);

/// Exponents of a modulus of uniform_stress(state).
/// \throws   InvalidArgument as uniform_strain_exponents, and for G and E at k_t = 0, where they vanish
/// Accuracy  1e-12 absolute; of G_hh, E_v and E_h 1e-12 (1 + 1/r), r = k_t/k_n, and none below r = 1e-13.
///            Checked by tests/effective/test_exponents.cpp
[[nodiscard]] StressExponents uniform_stress_exponents(const State& state, Modulus which);

/// \file
/// The uniform-field estimates by name: how the grains move, and which force sets the contact stiffness.

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

/// \file
/// Exponents of relaxed moduli. G of loose packings grows faster with stress than the contacts stiffen,
/// because new contacts form and move the network away from the isostatic point.

/// Change of a packing along a path, per ln p.
struct Growth {
  double coordination_number = 0;            ///< d ln C_n/d ln p [1]
  double mechanical_coordination_number = 0; ///< d z*/d ln p [1]
  double void_ratio = 0;                     ///< d e/d ln p [1], negative under compression
};

/// A packing at one mean stress.
struct MeasuredPacking {
  double pressure = State::unset;                       ///< p > 0 [Pa]
  double coordination_number = State::unset;            ///< C_n > 0 [1]
  double mechanical_coordination_number = State::unset; ///< z* > 0 [1]
  double void_ratio = State::unset;                     ///< e > 0 [1]
};

/// Mean growth between two pressures of a path.
/// \throws   InvalidArgument if a member is out of its range or the pressures are equal
/// Accuracy  rounding.  Checked by tests/effective/test_relaxed_exponents.cpp
[[nodiscard]] Growth growth_between(const MeasuredPacking& first, const MeasuredPacking& second);

/// Exponents of a modulus of relaxed(state, z*) while the packing grows with the mean stress; fabric stays.
/// Isotropic: s = b + (1-b) (d ln C_n/d ln p - d ln(1+e)/d ln p) + d ln h/dz* d z*/d ln p, b = 1/(1+alpha).
/// Under anisotropic stress d ln p = (stress_v d ln stress_v + 2 stress_h d ln stress_h)/(3p) splits the
/// growth between m and n. A Growth of zeros gives the exponents at frozen contacts.
/// \param    mechanical_coordination_number   z* [1]
/// \param    growth   at this state
/// Vanishing constants of uniform strain, such as C12 and C13 at k_t = k_n, stay zero at every stress.
/// \throws   InvalidArgument as relaxed, without stress or contacts, for a growth that is not finite, for a
///           z* at or below the isostatic point, and for a modulus that vanishes
/// Accuracy  against s fitted to networks of granum's specimens, 10 to 100 kPa, growth given: 0.03. Where
///           forces become more even, as after friction was switched on, s between two states is up to 0.04
///           larger.
///           Rounding: absolute 1e-10.
/// Checked by tests/effective/test_relaxed_exponents.cpp, validation/relaxation
[[nodiscard]] StressExponents relaxed_exponents(const State& state, double mechanical_coordination_number,
                                                const Growth& growth, Modulus which);

/// Growth of z* as compression closes gaps: z* = z_0 + A (1 - s b) w^q, w the overlap at the mean force over
/// the diameter, b of k_n ~ f^b; the fraction of rattlers decreases as x_0 = c exp(-k (z* - 4)).
/// It predicts s from the recipe alone, without a packing; validation/relaxation compares it with networks.
/// For a packing with known contacts at one pressure, carried_contacts is more accurate and covers every
/// recipe.
struct ClosingGapLaw {
  double initial = 0;       ///< z_0
  double amplitude = 0;     ///< A
  double exponent = 0;      ///< q
  double spread = 0;        ///< s
  double rattlers = 0;      ///< c
  double rattler_decay = 0; ///< k
  double scatter = 0;       ///< standard deviation of z* of specimens about the law
};

/// Specimens compressed without friction up to 10 kPa, with friction from there.
/// [validation/relaxation]
[[nodiscard]] const ClosingGapLaw& dense_closing_gaps();
/// Specimens opened below jamming and compressed with a friction angle of 26.5 degrees.
/// [validation/relaxation]
[[nodiscard]] const ClosingGapLaw& loose_closing_gaps();

/// Prediction of such a law at one pressure.
struct PredictedPacking {
  double coordination_number = 0;
  double mechanical_coordination_number = 0;
  Growth growth;
};

/// C_n, z* and their growth at isotropic stress. C_n and the mean force, f = 4 pi R^2 (1+e) p/C_n, depend on
/// each other and are solved together; e is constant. Of rough spheres the overlap of smooth ones counts.
/// \param    state   law, radius, void_ratio; its coordination number and stresses are not used
/// \param    pressure   p > 0 [Pa]
/// \throws   InvalidArgument if pressure, radius or void_ratio are not positive
/// Accuracy  of z*: law.scatter, for specimens made in this way and overlaps below 0.01.
/// Checked by tests/effective/test_relaxed_exponents.cpp, validation/relaxation
[[nodiscard]] PredictedPacking predict_packing(const ClosingGapLaw& law, const State& state, double pressure);

} // namespace granum::effective
