// SPDX-License-Identifier: GPL-3.0-or-later
#include "question.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <map>

#include <granum/core/error.hpp>
#include <granum/estimate/inputs.hpp>

#include "shared_keywords.hpp"

namespace granum::python {

namespace {

using estimate::Input;
using estimate::InputRow;
using estimate::InputValues;

/// The numbers that a question may have beside those of state_keywords.
constexpr Input numbers_beside_state[] = {Input::grain_density, Input::saturation, Input::shear_strain};

} // namespace

std::vector<Keyword> sand_keywords(const char* type_of_name) {
  std::vector<Keyword> all{
      optional("sand", type_of_name,
               "A sand by name, \"toyoura\", with its published limits of the void ratio, C_u, d50 and "
               "tests; implies\n    grain_shape \"sand\" unless that is given.")};
  for (const Input input : numbers_of_sand)
    all.push_back(of_input(input).or_none());
  all[2].says =
      "Smallest void ratio e_min [1], in [0.1, 4.95], below largest_void_ratio by 0.05 or more; with both "
      "the\n    relative density is known. Unknown by default.";
  all[6].says = "Median diameter by mass of a sand [m], > 0.";
  all[4].says += " That of the sand at void_ratio; its law takes it unless both limits are known.";
  return all;
}

std::vector<Keyword> question_keywords(const std::vector<Keyword>& more) {
  Keyword density = of_input(Input::grain_density).or_none();
  density.says += " Without it no wave speeds.";
  std::vector<Keyword> all =
      state_keywords() +
      std::vector<Keyword>{
          preparation_keyword(), density, of_input(Input::saturation).or_number(0),
          optional("uncertainty", "dict",
                   "Standard deviations by the names of numbers, grain_shear_modulus and\n    "
                   "grain_poisson_ratio: {\"void_ratio\": 0.01} [their units]. A fabric_anisotropy that is "
                   "not given\n    is 0, with a deviation of 0.05 or more under unequal stresses, as in "
                   "granum estimate."),
          optional(
              "grain_shape", "str",
              "\"sphere\", the model of spheres, or \"sand\", laws measured on sands; both give the same "
              "fields. By\n    default \"sand\" if a number or the name of a sand is given, else "
              "\"sphere\".")} +
      sand_keywords("str or array of str") + std::vector<Keyword>{of_input(Input::shear_strain).or_none()};
  const auto named = [&all](const char* name) {
    return std::find_if(all.begin(), all.end(), [name](const Keyword& of) { return of.name == name; });
  };
  all.erase(named("unevenness")); // a question has its preparation
  const auto contacts = named("coordination_number");
  *contacts = contacts->or_none();
  const auto void_ratio = named("void_ratio");
  *void_ratio = void_ratio->or_none();
  void_ratio->says += " Of a sand it follows from relative_density where that is given instead.";
  named("least_void_ratio")->says += " Of beads (grain_shape \"sphere\") that of the same grains\n    packed "
                                     "without friction, from 0.5 (0.2 of "
                                     "unequal grains) to void_ratio: contacts that are not given are\n    "
                                     "estimated from the void ratio above "
                                     "it; above 0.58 it is not used, with a note.";
  return all + more;
}

std::size_t question_keyword_count() {
  static const std::size_t count = question_keywords().size();
  return count;
}

InputValues values_of_law(const contact::NormalLaw& law) {
  InputValues values;
  values.by_keywords = values.without_density = true;
  values.give(law);
  return values;
}

void give_word(InputValues& values, Input input, const Arguments& a, std::size_t at) {
  if (a.given(at))
    values.give(input, a.text(at));
}

estimate::Deviations deviations_of(const Arguments& a, std::size_t at, std::span<const InputRow* const> rows,
                                   const std::string& other) {
  estimate::Deviations stated;
  if (!a.given(at))
    return stated;
  for (const auto& entry :
       a.as<std::map<std::string, double>>(at, "a dict of inputs and their standard deviations")) {
    const std::string& name = entry.first;
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const InputRow* const one) {
      return one->law == nullptr && one->name() == name; // numbers of laws belong to law objects
    });
    if (row == rows.end())
      throw InvalidArgument("uncertainty: " + name + " is not " + other);
    stated[(*row)->input] = require_non_negative("uncertainty of " + name, entry.second);
  }
  return stated;
}

namespace {

/// Where a keyword of a question is in the call of any function that has them first.
std::size_t place_of(std::string_view name) {
  static const std::map<std::string, std::size_t, std::less<>> places = [] {
    std::map<std::string, std::size_t, std::less<>> all;
    for (const Keyword& keyword : question_keywords())
      all.emplace(keyword.name, all.size());
    return all;
  }();
  return places.find(name)->second;
}

struct InputPlace {
  Input input;
  std::size_t place;
};

/// The numbers of a question, with the places of their keywords.
const std::vector<InputPlace>& numbers_of_question() {
  static const std::vector<InputPlace> all = [] {
    std::vector<InputPlace> numbers;
    const auto add = [&](Input input) {
      numbers.push_back({input, place_of(estimate::row_of(input).name())});
    };
    for (const Input input : {Input::radius, Input::void_ratio, Input::coordination_number, Input::pressure,
                              Input::stress_v, Input::stress_h, Input::fabric, Input::tangential_ratio,
                              Input::rolling, Input::mechanical_coordination_number, Input::rattler_fraction})
      add(input);
    for (const Input input : numbers_beside_state)
      add(input);
    for (const Input input : numbers_of_sand)
      add(input);
    return numbers;
  }();
  return all;
}

/// \throws   TypeError for stresses or contacts that are given twice, or stresses that are missing
void require_alternatives(const Arguments& a) {
  static const std::size_t e = place_of("void_ratio"), D_r = place_of("relative_density"),
                           pressure = place_of("pressure"), v = place_of("stress_v"),
                           h = place_of("stress_h"), z = place_of("mechanical_coordination_number"),
                           rattlers = place_of("rattler_fraction");
  if (!a.given(e) && !a.given(D_r))
    throw py::type_error(std::string(a.function().name) +
                         "() needs the keyword argument 'void_ratio', or 'relative_density' of a sand");
  for (const bool vertical : {true, false})
    (void)stress_argument(a, pressure, v, h, vertical);
  if (a.given(z) && a.given(rattlers))
    throw py::type_error("mechanical_coordination_number and rattler_fraction are alternatives: give one");
}

} // namespace

QuestionArguments::QuestionArguments(const Arguments& a)
    : values_(values_of_law(a.as<const contact::NormalLaw&>(0, "a contact law"))) {
  static const std::size_t means = place_of("contact_means"), strict = place_of("strict"),
                           uncertainty = place_of("uncertainty");
  static const InputPlace words[] = {{Input::preparation, place_of("preparation")},
                                     {Input::grain_shape, place_of("grain_shape")}};
  static const std::size_t sand = place_of("sand");
  strict_ = a.flag(strict);
  require_alternatives(a);
  if (a.given(means))
    values_.contact_means = a.as<sizes::ContactMeans>(means, "ContactMeans");
  for (const auto& [input, place] : words)
    give_word(values_, input, a, place);
  if (a.given(sand) && !py::isinstance<py::str>(a[sand]))
    take_sands(a[sand]);
  else
    give_word(values_, Input::sand, a, sand);
  for (const auto& [input, place] : numbers_of_question())
    if (a.given(place) || input == Input::radius) {
      columns_.push_back({a.name(place), a[place], a.keyword(place).in_library});
      inputs_.push_back(input);
    }
  if (sand_places_)
    columns_.push_back({"sand", py::handle(sand_places_)});
  deviations_ = deviations_of(a, uncertainty, estimate::uncertain_rows(), "an input of this packing");
  require_in_use();
}

void QuestionArguments::take_sands(py::handle names) {
  const py::array all = py::array::ensure(names);
  const char kind = all ? all.dtype().kind() : ' ';
  if (kind != 'U' && kind != 'O' && !(all && all.size() == 0)) {
    PyErr_Clear();
    throw py::type_error("sand must be a string, or an array of them");
  }
  py::array_t<double> places(std::vector<py::ssize_t>(all.shape(), all.shape() + all.ndim()));
  std::map<std::string, std::size_t> known;
  double* to = places.mutable_data();
  for (const py::handle name : all.attr("ravel")().attr("tolist")()) {
    if (!py::isinstance<py::str>(name))
      throw py::type_error("sand must be a string, or an array of them, not one with " +
                           std::string(py::str(py::repr(name))));
    const auto [place, fresh] = known.emplace(name.cast<std::string>(), known.size());
    if (fresh)
      of_sands_.emplace_back(values_).give(Input::sand, place->first);
    *to++ = static_cast<double>(place->second);
  }
  if (!of_sands_.empty())
    values_ = of_sands_.front();
  sand_places_ = std::move(places);
}

const double* QuestionArguments::one_packing(const char* function) {
  const Columns columns(columns_);
  if (!columns.is_scalar())
    throw py::type_error(std::string(function) + "() takes a single packing: numbers, not arrays");
  numbers_.assign(columns.numbers(), columns.numbers() + columns_.size());
  return numbers_.data();
}

void QuestionArguments::require_in_use() const {
  InputValues any = values_;
  for (const Input input : inputs_)
    any.give(input, 1);
  if (any.given(Input::d50) && known_shape(any) != estimate::GrainShape::sand)
    throw py::type_error("d50 is a number of a sand; spheres have a radius");
  for (const auto& [input, deviation] : deviations_)
    if (!in_use(any, estimate::row_of(input)))
      throw InvalidArgument("uncertainty: " + std::string(estimate::row_of(input).name()) +
                            " is not an input of this packing");
}

estimate::Answer QuestionArguments::answer(const double* x) const {
  InputValues values = sand_places_ ? of_sands_[static_cast<std::size_t>(x[inputs_.size()])] : values_;
  for (std::size_t k = 0; k < inputs_.size(); ++k)
    values.give(inputs_[k], x[k]);
  values = completed(std::move(values));
  return estimate::answer(question_of(values), uncertain_inputs(values, deviations_));
}

} // namespace granum::python
