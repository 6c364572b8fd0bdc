// SPDX-License-Identifier: GPL-3.0-or-later
#include "likely_mistakes.hpp"

#include <fmt/core.h>
#include <granum/core/error.hpp>
#include <granum/core/text.hpp>

#include "slips.hpp"

namespace granum::cli {

namespace {

using estimate::Input;
using estimate::InputValues;

Typed typed(const InputValues& values, Input input) {
  return {values.name(input), values.number(input), estimate::row_of(input).dimension};
}

Typed key_of_scene(const char* name, double value, Dimension dimension) { return {name, value, dimension}; }

} // namespace

Validity likely_mistakes(const InputValues& values, const effective::State& state) {
  Validity validity;
  if (values.stated(Input::void_ratio))
    judge_void_ratio({values.name(Input::void_ratio), state.void_ratio}, values.sizes.has_value(), validity);
  const bool by_z = values.given(Input::mechanical_coordination_number);
  const Input z = by_z ? Input::mechanical_coordination_number : Input::coordination_number;
  if (values.given(z) && !values.sizes)
    judge_contacts(typed(values, z), by_z, state, validity);
  for (const Input stress : {Input::pressure, Input::stress_v, Input::stress_h})
    if (values.stated(stress)) // a stress that follows from others was not mistyped
      judge_stress(typed(values, stress), validity);
  for (const auto& [input, judge] : {std::pair{Input::radius, &judge_length},
                                     {Input::d50, &judge_length},
                                     {Input::grain_shear_modulus, &judge_modulus},
                                     {Input::grain_density, &judge_density}})
    if (values.given(input))
      judge(typed(values, input), validity);
  return validity;
}

Validity likely_mistakes(const Number& stress) {
  Validity validity;
  if (stress.given())
    judge_stress({stress.name, stress.value, stress.dimension}, validity);
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
