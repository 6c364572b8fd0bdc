// SPDX-License-Identifier: GPL-3.0-or-later
#include "answer_case.hpp"

#include <algorithm>
#include <cmath>

#include <granum/core/error.hpp>

namespace granum::cli {

using estimate::GrainShape;

const estimate::Answer* AnswerCase::of_kind(GrainShape shape) const {
  if (question.grain_shape == shape)
    return &answer;
  return shape == GrainShape::sand && sand_answer ? &*sand_answer : nullptr;
}

AnswerCase bare_answer(const InputValues& values, const std::vector<std::string>& uncertainties) {
  estimate::Question question = question_of(values);
  std::vector<estimate::UncertainInput> inputs = uncertain_inputs(values, uncertainties);
  std::optional<estimate::Answer> of_sand;
  std::string sand_refused;
  double sand_grain_modulus = 0;
  if (!known_shape(values)) {
    try {
      const InputValues sand = as_sand(values);
      const estimate::Question of_grains = question_of(sand);
      of_sand = estimate::answer(of_grains, uncertain_inputs(sand, uncertainties));
      sand_grain_modulus = of_grains.state.law.grain().shear_modulus;
    } catch (const InvalidArgument& refused) { // a sand cannot be so, but a packing of spheres can
      sand_refused = std::string("sand: ") + refused.what();
    }
  }
  try {
    estimate::Answer answer = estimate::answer(question, inputs);
    return {.question = std::move(question),
            .inputs = std::move(inputs),
            .answer = std::move(answer),
            .sand_answer = std::move(of_sand),
            .sand_refused = std::move(sand_refused),
            .sand_grain_modulus = sand_grain_modulus};
  } catch (const InvalidArgument& refused) {
    if (!of_sand)
      throw;
    AnswerCase sand = bare_answer(as_sand(values), uncertainties);
    sand.beads_refused = std::string("beads: ") + refused.what();
    return sand;
  }
}

AnswerCase solve_answer(const InputValues& values, const std::vector<std::string>& uncertainties) {
  AnswerCase c = bare_answer(values, uncertainties);
  add_measured_laws(c);
  c.assumptions = notes_of(c.beads_refused.empty() ? values : as_sand(values), c.question, c.inputs,
                           c.of_sand() != nullptr);
  return c;
}

InputValues at_stress(InputValues values, const stress::AxialStress& stress) {
  values.set_stresses(stress);
  return values;
}

void add_measured_laws(AnswerCase& c) {
  const estimate::Question& q = c.question;
  c.uniformity = q.sand.uniformity.value_or(sands::uniform_sand);
  c.uniformity_assumed = !q.sand.uniformity;
  sands::SandState sand{
      .void_ratio = q.state.void_ratio, .mean_stress = q.state.mean_stress(), .uniformity = c.uniformity};
  sand.d50 = q.sand.d50.value_or(sand.d50);
  if (!(sand.mean_stress > 0))
    return;
  for (const sands::MeasuredLaw& law : sands::measured_laws()) {
    c.sands.push_back({&law, std::nullopt});
    try {
      c.sands.back().modulus = sands::shear_modulus(law, sand);
    } catch (const InvalidArgument&) { // a void ratio beyond the zero of the law, or grains that are no sand
    }
  }
}

std::vector<bool> laws_tested(const AnswerCase& c) {
  std::vector<bool> tested;
  for (const SandAnswer& sand : c.sands)
    tested.push_back(sand.tested());
  return tested;
}

std::optional<estimate::Range> range_of_laws(const AnswerCase& c, const std::vector<bool>& some) {
  const bool all = std::find(some.begin(), some.end(), true) == some.end();
  double low = INFINITY, high = 0;
  for (std::size_t k = 0; k < c.sands.size(); ++k)
    if (c.sands[k].modulus && (all || some.at(k))) {
      low = std::min(low, c.sands[k].modulus->shear_modulus);
      high = std::max(high, c.sands[k].modulus->shear_modulus);
    }
  if (!(high > 0))
    return std::nullopt;
  return estimate::Range{.value = std::sqrt(low * high), .low = low, .high = high};
}

} // namespace granum::cli
