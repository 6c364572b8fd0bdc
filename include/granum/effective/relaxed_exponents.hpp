// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/effective/exponents.hpp>
#include <granum/effective/state.hpp>

/// Exponents of relaxed moduli. G of loose packings grows faster with stress than the contacts stiffen,
/// because new contacts form and move the network away from the isostatic point.
namespace granum::effective {

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
