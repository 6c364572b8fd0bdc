// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/effective/contact_prior.hpp>
#include <granum/effective/relaxation.hpp>
#include <granum/inverse/inference.hpp>

#include "unit.hpp"

/// Beads, what they show, and how it is inferred from.
namespace inferences {

using effective::Modulus;
using effective::State;
using inverse::GrowthRule;
using inverse::infer;
using inverse::InferenceOptions;
using inverse::Observation;
using inverse::Quantity;

inline constexpr double density = 2480;

/// Glass beads under a vertical and a horizontal stress.
inline State beads(double stress_v, double stress_h, double void_ratio = 0.61, double grain_modulus = 29e9) {
  const contact::GrainMaterial glass{.shear_modulus = grain_modulus, .poisson_ratio = 0.2};
  return {.law = contact::PowerLaw::sphere(glass, 0.5e-3),
          .tangential_ratio = contact::mindlin_stiffness_ratio(0.2),
          .radius = 0.5e-3,
          .void_ratio = void_ratio,
          .stress_v = stress_v,
          .stress_h = stress_h};
}
inline State beads(double pressure) { return beads(pressure, pressure); }

/// What a packing of that z* shows.
inline double value_of(Quantity quantity, const State& state, double z, double rattler_fraction) {
  const auto& row = inverse::row_of(quantity);
  const auto stiffness = relaxed(effective::with_contacts(state, z, rattler_fraction), z).stiffness;
  const double x = modulus(stiffness, row.modulus);
  return row.speed ? std::sqrt(x / (density / (1 + state.void_ratio))) : x;
}
inline double value_of(Quantity quantity, const State& state, double z) {
  return value_of(quantity, state, z, effective::expected_rattlers(state, z).fraction);
}

inline Observation measurement(Quantity quantity, const State& state, double z, double relative_error = 0) {
  const double value = value_of(quantity, state, z);
  return {quantity, {value, relative_error * value}, state};
}

inline InferenceOptions options_with(GrowthRule growth = GrowthRule::fixed) {
  return {.grain_density = density, .growth = growth};
}

inline inverse::SharedInputs grain_modulus_within(double relative_error) {
  return {{"grain-shear-modulus"},
          [relative_error](State& state, double&, std::span<const double> deviations) {
            const contact::GrainMaterial grain = state.law.grain();
            const double moved = grain.shear_modulus * std::exp(relative_error * deviations[0]);
            state.law = contact::PowerLaw::sphere({moved, grain.poisson_ratio}, state.radius);
          }};
}

} // namespace inferences
