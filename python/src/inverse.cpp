// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstddef>

#include <granum/core/measured.hpp>
#include <granum/inverse/inference.hpp>

#include "bindings.hpp"
#include "errors.hpp"
#include "inverse.hpp"
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

py::object predict(const Answer& answer, const std::string& quantity, const py::object& pressure,
                   const py::object& stress_v, const py::object& stress_h, const py::object& void_ratio,
                   const std::string& specimen) {
  const Inference& inference = together(answer);
  const inverse::Quantity asked = inverse::quantity_of(quantity);
  const inverse::AskedPacking which = inverse::asked_packing_of(specimen);
  return predicted_rows(
      {pressure, stress_v, stress_h, void_ratio}, answer.first,
      [&](double mean_stress) { return inference.void_ratio_at(mean_stress); },
      [&](const effective::State& at, Notes& notes) {
        const Measured found = inference.predict(asked, at, which);
        notes.add(inference.doubts(at, which));
        return found;
      });
}

inverse::InferredPacking contacts(const Answer& answer) { return together(answer).packing(answer.first); }

const std::string predict_documentation =
    std::string("A quantity of the packing at other stresses, with its standard error.\n") +
    elsewhere_parameters + R"(void_ratio : array_like, optional
    e there [1]; without it that of the packing as pressure changes it.
specimen : str
    "same", or "prepared_alike": another one of the same grains, at the void ratio given.

Returns
-------
MeasuredRows

Raises
------
InvalidArgument
    For another quantity, or a wave speed without grain_density.
NotConverged
    Where no coordination number explains what was measured.
)";

void bind_answer(py::module_& module) {
  py::class_<Answer>(module, "Inference", R"(What measurements say of the contacts of a packing.

Its numbers raise NotConverged where no coordination number explains what was measured; `explained` tells.)")
      .def_property_readonly(
          "explained", [](const Answer& a) { return a.found.together.has_value(); },
          "Whether any coordination number explains what was measured.")
      .def_property_readonly(
          "pressure", [](const Answer& a) { return together(a).reference_stress(); },
          "Mean stress that the contacts belong to: that of the first measurement [Pa].")
      .def_property_readonly(
          "mechanical_coordination_number",
          [](const Answer& a) { return contacts(a).mechanical_coordination_number; }, "z* [1].")
      .def_property_readonly(
          "rattler_fraction", [](const Answer& a) { return contacts(a).rattler_fraction; }, "x_0 [1].")
      .def_property_readonly(
          "coordination_number", [](const Answer& a) { return contacts(a).coordination_number; }, "C_n [1].")
      .def_property_readonly(
          "alone",
          [](const Answer& a) {
            std::vector<std::optional<Measured>> out;
            for (const inverse::AloneAnswer& one : a.found.alone)
              out.push_back(one.mechanical_coordination_number);
            return out;
          },
          "z* that each measurement implies by itself; None where no coordination number explains it.")
      .def_property_readonly(
          "fitted", [](const Answer& a) { return fitted_values(together(a).measurements()); },
          "Each measurement as all of them together have it [Pa or m/s].")
      .def_property_readonly(
          "deviations", [](const Answer& a) { return deviations(together(a).measurements()); },
          "ln of measured over fitted, in standard errors, of each measurement.")
      .def_property_readonly(
          "error_shares",
          [](const Answer& a) {
            py::dict out;
            for (const inverse::ErrorShare& share : together(a).error_shares())
              out[py::str(share.source)] = share.share;
            return out;
          },
          "Of the variance of z*, what each source makes [0, 1].")
      .def_property_readonly(
          "growth_exponent", [](const Answer& a) { return together(a).growth_exponent(); },
          "Of growth = fitted; else None.")
      .def_property_readonly(
          "contact_numbers",
          [](const Answer& a) {
            py::dict out;
            if (const auto& implied = together(a).contacts())
              for (const inverse::ImpliedNumber& number : implied->numbers)
                out[py::str(number.key)] = number.value;
            return out;
          },
          "z* and the numbers of the contact law that were asked for, by name; SI. Empty for contacts = "
          "given.")
      .def_property_readonly(
          "undetermined",
          [](const Answer& a) {
            std::vector<std::string> out;
            if (const auto& implied = together(a).contacts())
              for (const inverse::ImpliedNumber& number : implied->numbers)
                if (!number.determined())
                  out.push_back(number.key);
            return out;
          },
          "Those of contact_numbers that the measurements cannot tell.")
      .def_property_readonly(
          "would_determine",
          [](const Answer& a) {
            const auto& implied = together(a).contacts();
            return implied && implied->would_determine
                       ? std::optional<std::string>(inverse::row_of(*implied->would_determine).key)
                       : std::nullopt;
          },
          "What would tell them, measured at the same states within 2 %; None where nothing would.")
      .def_property_readonly(
          "contact_law",
          [](const Answer& a) {
            const auto& implied = together(a).contacts();
            return implied ? implied->law : std::nullopt;
          },
          "The law that is implied; None for contacts = given.")
      .def_property_readonly(
          "chi_square", [](const Answer& a) { return together(a).chi_square(); },
          "Sum of squared deviations.")
      .def_property_readonly(
          "degrees_of_freedom", [](const Answer& a) { return together(a).degrees_of_freedom(); },
          "How many of them are free.")
      .def_property_readonly(
          "probability", [](const Answer& a) { return together(a).probability(); },
          "That errors as stated make chi_square so large.")
      .def_property_readonly(
          "notes", [](const Answer& a) { return a.found.validity.notes; },
          "What cannot be explained, or contradicts, a sentence each.")
      .def("predict", &predict, py::arg("quantity"), py::kw_only(), py::arg("pressure") = py::none(),
           py::arg("stress_v") = py::none(), py::arg("stress_h") = py::none(),
           py::arg("void_ratio") = py::none(), py::arg("specimen") = "same", predict_documentation.c_str())
      .def("__repr__", [](const Answer& a) {
        if (!a.found.together)
          return std::string("<Inference: no coordination number explains what was measured>");
        const Measured z = contacts(a).mechanical_coordination_number;
        return "Inference(mechanical_coordination_number=" +
               std::string(py::str("{:.3f} +- {:.3f})").format(z.value, z.standard_error));
      });
}

} // namespace

py::object predicted_rows(const Elsewhere& where, const effective::State& first,
                          const std::function<double(double)>& void_ratio_at,
                          const std::function<Measured(const effective::State& at, Notes& notes)>& predict) {
  PyObject* const stresses[] = {where.pressure.ptr(), where.stress_v.ptr(), where.stress_h.ptr()};
  static const KeywordFunction function{"predict", {{"pressure"}, {"stress_v"}, {"stress_h"}}, nullptr, ""};
  const Arguments arguments(function, stresses);
  const bool own_void_ratio = where.void_ratio.is_none();
  const Argument columns[] = {
      stress_argument(arguments, 0, 1, 2, true), stress_argument(arguments, 0, 1, 2, false),
      own_void_ratio ? Argument{"void_ratio", 0.0} : Argument{"void_ratio", where.void_ratio}};
  return py::cast(answer_rows(columns, false, MeasuredRow{}, [&](const double* x, Notes& notes) {
    effective::State at = first;
    at.stress_v = x[0];
    at.stress_h = x[1];
    at.void_ratio = own_void_ratio ? void_ratio_at((x[0] + 2 * x[1]) / 3) : x[2];
    const Measured found = predict(at, notes);
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
  auto rows =
      result_class<MeasuredRow>(module, "MeasuredRows", "Numbers with standard errors, in their unit.");
  show_member<MeasuredRow>(rows, "value", offsetof(MeasuredRow, value), "The number.");
  show_member<MeasuredRow>(rows, "standard_error", offsetof(MeasuredRow, standard_error),
                           "Its standard error.");
  bind_answer(module);
  bind_sand_inference(module);
  bind_infer(module);
}

} // namespace granum::python
