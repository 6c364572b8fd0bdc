// SPDX-License-Identifier: GPL-3.0-or-later
#include "question.hpp"

#include <pybind11/stl.h>

#include <algorithm>

#include <granum/core/check.hpp>
#include <granum/core/number.hpp>
#include <granum/estimate/inputs.hpp>

namespace granum::python {

namespace {

enum : std::size_t {
  coordination_number_at = 3,
  preparation_at = state_keyword_count,
  density_at,
  saturation_at,
  uncertainty_at,
  grain_shape_at,
  sand_at,
  numbers_of_sand_at,
  shear_strain_at = numbers_of_sand_at + std::size(numbers_of_sand)
};

/// Indices of the columns after those of the state.
constexpr std::size_t density_column = 8, saturation_column = 9, sand_column = 10,
                      strain_column = sand_column + std::size(numbers_of_sand);

/// Inputs without a column: they change the contact law.
constexpr const char *of_modulus = "grain_shear_modulus", *of_ratio = "grain_poisson_ratio",
                     *of_fabric = "fabric_anisotropy";

/// Uncertain inputs in the order in which the program adds them up: sums have the same bits.
constexpr const char* inputs_in_order[] = {of_modulus,
                                           of_ratio,
                                           "radius",
                                           "tangential_ratio",
                                           "void_ratio",
                                           "coordination_number",
                                           "mechanical_coordination_number",
                                           "rattler_fraction",
                                           of_fabric,
                                           "pressure",
                                           "stress_v",
                                           "stress_h",
                                           "grain_density",
                                           "saturation"};

} // namespace

std::vector<Keyword> question_keywords(std::initializer_list<Keyword> more) {
  std::vector<Keyword> all = state_keywords(
      {{"preparation", "None"}, {"grain_density", "None"}, {"saturation", "0.0"}, {"uncertainty", "None"}});
  all.insert(all.end(), {{"grain_shape", "None"}, {"sand", "None"}});
  for (const SandNumber& number : numbers_of_sand)
    all.push_back({number.keyword, "None"});
  all.push_back({"shear_strain", "None"});
  all[coordination_number_at].shown_default = "None";
  all.insert(all.end(), more);
  return all;
}

const std::string question_parameters = state_parameters() +
                                        R"(preparation : str, optional
    "dense", "loose", or "friction:0.3", a friction coefficient; without it unknown.
grain_density : array_like, optional
    Of the grains' solid [kg/m3]; without it no wave speeds.
saturation : array_like
    Degree of saturation, in [0, 1] [1].
uncertainty : dict, optional
    Standard deviations by the names of numbers above, grain_shear_modulus and grain_poisson_ratio:
    {"void_ratio": 0.01} [their units]. A fabric_anisotropy that is not given is 0, with a deviation of 0.05
    or more under unequal stresses, as in granum estimate.
grain_shape : str, optional
    "sphere", the model of spheres, or "sand", laws measured on sands; both give the same fields. By default
    "sand" if a number or the name of a sand is given, else "sphere".
sand : str, optional
    A sand by name, "toyoura", with its published limits of the void ratio, C_u, d50 and tests; implies
    grain_shape "sand" unless that is given.
uniformity : array_like, optional
    C_u = d60/d10 of a sand, >= 1 [1].
least_void_ratio, largest_void_ratio : array_like, optional
    e_min and e_max of a sand [1].
relative_density : array_like, optional
    D_r of a sand of void_ratio, in [0, 1.2]; its law takes it unless both limits are known [1].
d50 : array_like, optional
    Of a sand [m].
shear_strain : array_like, optional
    For sands: amplitude of a shear strain at which G is computed as well, in (0, 0.05] [1].
)";

Grains grains_of(const Arguments& a, std::size_t grain_shape_at, std::size_t sand_at) {
  Grains grains;
  if (a.given(sand_at)) {
    grains.sand = &sands::known_sand(a.text(sand_at));
    grains.shape = estimate::GrainShape::sand;
  }
  if (a.given(grain_shape_at))
    grains.shape = estimate::grain_shape_of(a.text(grain_shape_at));
  return grains;
}

QuestionArguments::QuestionArguments(const Arguments& a)
    : state_(a, StateArguments::CoordinationNumber::optional), has_density_(a.given(density_at)),
      has_strain_(a.given(shear_strain_at)), grains_(grains_of(a, grain_shape_at, sand_at)),
      columns_(state_.columns().begin(), state_.columns().end()) {
  if (a.given(preparation_at))
    preparation_ = effective::preparation_of(a.text(preparation_at));
  columns_.push_back({"grain_density", 0.0});
  if (has_density_)
    columns_.back().value = a[density_at];
  columns_.push_back({"saturation", 0.0});
  if (a.given(saturation_at))
    columns_.back().value = a[saturation_at];
  for (std::size_t k = 0; k < has_number_of_sand_.size(); ++k) {
    columns_.push_back({numbers_of_sand[k].keyword, 0.0});
    has_number_of_sand_[k] = a.given(numbers_of_sand_at + k);
    if (has_number_of_sand_[k])
      columns_.back().value = a[numbers_of_sand_at + k];
  }
  columns_.push_back({"shear_strain", 0.0});
  if (has_strain_)
    columns_.back().value = a[shear_strain_at];
  // A sand has these numbers, and nothing else of a packing.
  const bool told_of_sand =
      std::any_of(std::begin(numbers_of_sand), std::end(numbers_of_sand), [&](const SandNumber& number) {
        const estimate::InputRow* const row = estimate::find_input(number.keyword);
        const bool implied =
            row == nullptr || row->implies == estimate::GrainShape::sand; // C_u has no row yet
        return implied && has_number_of_sand_[static_cast<std::size_t>(&number - numbers_of_sand)];
      });
  if (!a.given(grain_shape_at) && (told_of_sand || has_strain_))
    grains_.shape = estimate::GrainShape::sand;
  if (!a.given(uncertainty_at))
    return;
  for (const auto& [name, deviation] : a.as<std::map<std::string, double>>(
           uncertainty_at, "a dict of inputs and their standard deviations")) {
    const auto* const end = std::end(inputs_in_order);
    if (std::find(std::begin(inputs_in_order), end, std::string_view(name)) == end)
      throw InvalidArgument("uncertainty: " + name + " is not an input of this packing");
    deviations_[name] = require_non_negative("uncertainty of " + name, deviation);
  }
}

const double* QuestionArguments::one_packing(const char* function) {
  const Columns columns(columns_);
  if (!columns.is_scalar())
    throw py::type_error(std::string(function) + "() takes a single packing: numbers, not arrays");
  numbers_.assign(columns.numbers(), columns.numbers() + columns_.size());
  return numbers_.data();
}

estimate::Question QuestionArguments::question(const double* x) const {
  estimate::Question question = state_.question(x);
  question.preparation = preparation_;
  if (has_density_)
    question.grain_density = x[density_column];
  question.saturation = x[saturation_column];
  question.grain_shape = grains_.shape;
  question.sand = grains_.known();
  for (std::size_t k = 0; k < has_number_of_sand_.size(); ++k)
    if (has_number_of_sand_[k]) {
      question.sand.*numbers_of_sand[k].member = x[sand_column + k];
      if (numbers_of_sand[k].member != &sands::Sand::d50 &&
          numbers_of_sand[k].member != &sands::Sand::relative_density)
        question.sand.tests.reset(); // those of the named sand are of another batch
    }
  if (has_strain_)
    question.shear_strain = x[strain_column];
  return question;
}

estimate::UncertainInput QuestionArguments::input(const std::string& name, double deviation, bool assumed,
                                                  const double* x) const {
  const auto moved = [this, name, numbers = std::vector(x, x + columns_.size())](double change) {
    std::vector<double> there = numbers;
    for (std::size_t k = 0; k < columns_.size(); ++k) // pressure is both stresses
      if (columns_[k].name == name)
        there[k] += change;
    estimate::Question moved_question = question(there.data());
    if (name != of_modulus && name != of_ratio)
      return moved_question;
    effective::State& state = moved_question.state;
    contact::GrainMaterial grain = state.law.grain();
    (name == of_modulus ? grain.shear_modulus : grain.poisson_ratio) += change;
    state.law = state.law.of_grain(grain);
    if (!state_.knows_tangential_ratio())
      state.tangential_ratio = contact::mindlin_stiffness_ratio(grain.poisson_ratio);
    return moved_question;
  };
  return {.input = name == of_fabric ? std::string(estimate::fabric_input) : name,
          .deviation = deviation,
          .assumed = assumed,
          .moved = moved};
}

estimate::Answer QuestionArguments::answer(const double* x) const {
  const estimate::Question asked = question(x);
  std::vector<estimate::UncertainInput> inputs;
  for (const char* name : inputs_in_order) {
    const auto stated = deviations_.find(name);
    const bool fabric = std::string_view(name) == of_fabric;
    if (stated != deviations_.end() && stated->second > 0)
      inputs.push_back(input(name, stated->second, false, x));
    else if (stated == deviations_.end() && fabric && !state_.knows_fabric())
      inputs.push_back(input(
          name, estimate::assumed_fabric_deviation(asked.state.stress_v, asked.state.stress_h), true, x));
  }
  return estimate::answer(asked, inputs);
}

} // namespace granum::python
