// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstddef>

#include <granum/core/numerics.hpp>
#include <granum/inverse/inference.hpp>

#include "bindings.hpp"
#include "errors.hpp"
#include "inverse.hpp"
#include "members.hpp"
#include "shared_keywords.hpp"
#include "state.hpp"

namespace granum::python {

namespace {

using inverse::Inference;
using inverse::InferenceAnswer;

/// An answer with the state that predictions begin from.
struct Answer {
  InferenceAnswer found;
  effective::State first;
};

/// What follows of an answer: `together`, or the reason why there is nothing.
const Inference& together(const Answer& answer) {
  if (answer.found.together)
    return *answer.found.together;
  std::string why = "no coordination number explains what was measured";
  for (const std::string& note : answer.found.validity.notes)
    why += "; " + note;
  throw NotConverged(why);
}

py::object predict(const Arguments& a) {
  const auto& answer = a.as<const Answer&>(0);
  const Inference& inference = together(answer);
  const inverse::Quantity asked = inverse::quantity_of(a.text(1));
  const inverse::AskedPacking which = inverse::asked_packing_of(a.given(7) ? a.text(7) : "same");
  return predicted_rows(
      a, answer.first, [&](double mean_stress) { return inference.void_ratio_at(mean_stress); },
      [&](const effective::State& at, std::optional<double> saturation, Notes& notes) {
        const Measured found = inference.predict(asked, at, which, saturation);
        notes.add(inference.doubts(at, which));
        return found;
      });
}

inverse::InferredPacking contacts(const Answer& answer) { return together(answer).packing(answer.first); }

/// By the names of what is determined: the numbers of the contact law.
py::dict contact_numbers(const Answer& a) {
  py::dict out;
  if (const auto& implied = together(a).contacts())
    for (const inverse::ImpliedNumber& number : implied->numbers)
      out[py::str(number.key)] = number.value;
  return out;
}

std::vector<std::string> undetermined(const Answer& a) {
  std::vector<std::string> out;
  if (const auto& implied = together(a).contacts())
    for (const inverse::ImpliedNumber& number : implied->numbers)
      if (!number.determined())
        out.push_back(number.key);
  return out;
}

std::optional<std::string> would_determine(const Answer& a) {
  const auto& implied = together(a).contacts();
  return implied && implied->would_determine
             ? std::optional<std::string>(inverse::row_of(*implied->would_determine).key)
             : std::nullopt;
}

py::dict error_shares(const Answer& a) {
  py::dict out;
  for (const inverse::ErrorShare& share : together(a).error_shares())
    out[py::str(share.source)] = share.share;
  return out;
}

std::optional<contact::NormalLaw> contact_law(const Answer& a) {
  const auto& implied = together(a).contacts();
  return implied ? implied->law : std::nullopt;
}

std::string inference_text(const Answer& a) {
  if (!a.found.together)
    return "<Inference: no coordination number explains what was measured>";
  const Measured z = contacts(a).mechanical_coordination_number;
  return "Inference(mechanical_coordination_number=" +
         std::string(py::str("{:.3f} +- {:.3f})").format(z.value, z.standard_error));
}

void bind_answer(py::module_& module) {
  using inverse::InferredPacking;
  ResultClass<Answer> type(module, "Inference", R"(What measurements say of the contacts of a packing.

Its numbers raise NotConverged where no coordination number explains what was measured: `explained` is
False.)",
                           py::dynamic_attr());
  type.show("explained", "Whether any coordination number explains what was measured.",
            [](const Answer& a) { return a.found.together.has_value(); })
      .show("pressure", "Mean stress that the contacts belong to: that of the first measurement [Pa].",
            &together, &Inference::reference_stress)
      .show("mechanical_coordination_number", "z* [1].", &contacts,
            &InferredPacking::mechanical_coordination_number)
      .show("rattler_fraction", "x_0 [1].", &contacts, &InferredPacking::rattler_fraction)
      .show("coordination_number", "C_n [1].", &contacts, &InferredPacking::coordination_number)
      .show("alone",
            "z* that each measurement implies by itself; None where no coordination number explains it.",
            [](const Answer& a) {
              std::vector<std::optional<Measured>> out;
              for (const inverse::AloneAnswer& one : a.found.alone)
                out.push_back(one.mechanical_coordination_number);
              return out;
            })
      .show("fitted", "Each measurement as all of them together have it [Pa or m/s].",
            [](const Answer& a) { return fitted_values(together(a).measurements()); })
      .show("deviations", "ln of measured over fitted, in standard errors, of each measurement.",
            [](const Answer& a) { return deviations(together(a).measurements()); })
      .show("error_shares", "Of the variance of z*, what each source makes [0, 1].", &error_shares)
      .show("growth_exponent", "Of growth = fitted; else None.", &together, &Inference::growth_exponent)
      .show("contact_numbers",
            "z* and the numbers of the contact law that were asked for, by name; SI. Empty for contacts = "
            "given.",
            &contact_numbers)
      .show("undetermined", "Those of contact_numbers that the measurements do not determine.", &undetermined)
      .show("would_determine",
            "What would determine them, measured at the same states within 2 %; None where nothing would.",
            &would_determine)
      .show("contact_law", "The law that is implied; None for contacts = given.", &contact_law)
      .show("chi_square", "Sum of squared deviations.", &together, &Inference::chi_square)
      .show("degrees_of_freedom", "How many of them are free.", &together, &Inference::degrees_of_freedom)
      .show("probability", "That errors as stated make chi_square so large.", &together,
            &Inference::probability)
      .show("notes", "What cannot be explained, or contradicts, a sentence each.", &Answer::found,
            &InferenceAnswer::validity)
      .def("__repr__", &inference_text);
  define_method(
      type, "predict",
      predict_keywords("without it that of the packing as pressure changes it") +
          std::vector{with_default(
              "specimen", "'same'", "str",
              "\"same\", or \"prepared_alike\": another one of the same grains, at the void ratio given.")},
      {.summary = "A quantity of the packing at other stresses, with its standard error.",
       .returns = "MeasuredRows",
       .refuses = "For another quantity, or a wave speed without grain_density.",
       .more_errors = "NotConverged\n    Where no coordination number explains what was measured.\n"},
      &predict, 1);
}

} // namespace

std::vector<Keyword> predict_keywords(const std::string& otherwise) {
  using estimate::Input;
  Keyword void_ratio = of_input(Input::void_ratio).or_none();
  void_ratio.says += " Default: " + otherwise + ".";
  Keyword saturation = of_input(Input::saturation).or_none();
  saturation.says += " For speeds. Default: that of the measurements.";
  return {required("quantity", "str", "G, G_hh, K, V_s, V_s_hh, V_p or V_p_h."),
          of_input(Input::pressure).or_none(),
          of_input(Input::stress_v).or_none(),
          of_input(Input::stress_h).or_none(),
          void_ratio,
          saturation};
}

py::object predicted_rows(
    const Arguments& a, const effective::State& first, const std::function<double(double)>& void_ratio_at,
    const std::function<Measured(const effective::State& at, std::optional<double> saturation, Notes& notes)>&
        predict) {
  constexpr std::size_t pressure = 2, stress_v = 3, stress_h = 4, void_ratio = 5, saturation = 6;
  const bool own_void_ratio = !a.given(void_ratio);
  const Argument columns[] = {
      stress_argument(a, pressure, stress_v, stress_h, true),
      stress_argument(a, pressure, stress_v, stress_h, false),
      own_void_ratio ? Argument{"void_ratio", 0.0} : Argument{"void_ratio", a[void_ratio]},
      a.given(saturation) ? Argument{"saturation", a[saturation]} : Argument{"saturation", 0.0}};
  return py::cast(answer_rows(columns, false, MeasuredRow{}, [&](const double* x, Notes& notes) {
    effective::State at = first;
    at.stress_v = x[0];
    at.stress_h = x[1];
    at.void_ratio = own_void_ratio ? void_ratio_at((x[0] + 2 * x[1]) / 3) : x[2];
    const Measured found = predict(at, a.given(saturation) ? std::optional(x[3]) : std::nullopt, notes);
    return MeasuredRow{found.value, found.standard_error};
  }));
}

std::vector<Measured> fitted_values(const std::vector<inverse::FittedObservation>& all) {
  std::vector<Measured> out;
  for (const inverse::FittedObservation& one : all)
    out.push_back(one.value);
  return out;
}

std::vector<double> deviations(const std::vector<inverse::FittedObservation>& all) {
  std::vector<double> out;
  for (const inverse::FittedObservation& one : all)
    out.push_back(one.deviation);
  return out;
}

py::object sphere_inference(const std::vector<inverse::Observation>& measurements,
                            const inverse::InferenceOptions& options) {
  Answer answer{.found = {}, .first = measurements.front().state};
  {
    const Unlocked unlocked;
    answer.found = inverse::infer(measurements, options);
  }
  return py::cast(std::move(answer));
}

void bind_inverse(py::module_& module) {
  result_class<MeasuredRow>(module, "MeasuredRows", "Numbers with standard errors, in their unit.")
      .show("value", "The number.", &MeasuredRow::value)
      .show("standard_error", "Its standard error.", &MeasuredRow::standard_error);
  bind_answer(module);
  bind_sand_inference(module);
  bind_infer(module);
}

} // namespace granum::python
