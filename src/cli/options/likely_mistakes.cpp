// SPDX-License-Identifier: GPL-3.0-or-later
#include "likely_mistakes.hpp"

#include <fmt/core.h>
#include <granum/core/check.hpp>
#include <granum/core/number.hpp>

#include "slips.hpp"

namespace granum::cli {

namespace {

Typed typed(const Number& number) { return {number.name, number.value, number.dimension}; }

Typed key_of_scene(const char* name, double value, Dimension dimension) { return {name, value, dimension}; }

} // namespace

Validity likely_mistakes(const PackingOptions& o, const effective::State& state) {
  Validity validity;
  if (o.void_ratio.given() && !o.void_ratio.preset)
    judge_void_ratio({o.void_ratio.name, state.void_ratio}, o.sizes.has_value(), validity);
  const bool by_z = o.mechanical_coordination_number.given();
  const Number& z = by_z ? o.mechanical_coordination_number : o.coordination_number;
  if (z.given() && !o.sizes)
    judge_contacts(typed(z), by_z, state, validity);
  for (const Number* stress : {&o.pressure, &o.stress_v, &o.stress_h})
    if (stress->given() && !stress->preset) // a stress that follows from others was not mistyped
      judge_stress(typed(*stress), validity);
  for (const Number* length : {&o.radius, &o.d50})
    if (length->given())
      judge_length(typed(*length), validity);
  if (o.grain_shear_modulus.given())
    judge_modulus(typed(o.grain_shear_modulus), validity);
  return validity;
}

Validity likely_mistakes(const Number& density_or_stress) {
  Validity validity;
  if (density_or_stress.given()) {
    const auto judge = density_or_stress.dimension == Dimension::density ? judge_density : judge_stress;
    judge(typed(density_or_stress), validity);
  }
  return validity;
}

Validity likely_mistakes(const studies::Scene& scene) {
  Validity validity;
  judge_length(key_of_scene("grain.radius", scene.grain.radius, Dimension::length), validity);
  judge_modulus(key_of_scene("grain.shear_modulus", scene.grain.shear_modulus, Dimension::pressure),
                validity);
  judge_density(key_of_scene("grain.density", scene.grain.density, Dimension::density), validity);
  for (const double pressure : scene.study.pressures) {
    const std::size_t before = validity.notes.size();
    judge_stress(key_of_scene("study.pressures", pressure, Dimension::pressure), validity);
    if (validity.notes.size() > before)
      break; // the others have the same unit
  }
  return validity;
}

} // namespace granum::cli
