// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cmath>
#include <cstddef>
#include <limits>

#include <granum/core/measured.hpp>
#include <granum/inverse/inference.hpp>

#include "bindings.hpp"
#include "docstrings.hpp"
#include "shared_inputs.hpp"
#include "state.hpp"

namespace granum::python {

namespace {

using inverse::Inference;
using inverse::InferenceAnswer;

/// Keywords of infer in their order.
struct Given {
  enum : std::size_t {
    law,
    radius,
    void_ratio,
    pressure,
    stress_v,
    stress_h,
    fabric,
    tangential_ratio,
    contact_means,
    relative_error,
    grain_density,
    pore_density,
    rattlers,
    growth,
    contacts,
    uncertainty,
    quantities
  };
};

/// Columns of the state, and of the error of what is measured there; quantities stand behind.
struct Column {
  enum : std::size_t {
    radius,
    void_ratio,
    stress_v,
    stress_h,
    fabric,
    tangential_ratio,
    relative_error,
    quantities
  };
};

/// The columns of a call of infer: states, errors, and the quantities that are given.
struct MeasuredColumns {
  std::vector<Argument> arguments;
  std::vector<inverse::Quantity> given;
};

MeasuredColumns columns_of(const Arguments& a, const contact::NormalLaw& law) {
  MeasuredColumns out;
  out.arguments = {Argument{"radius", a[Given::radius]},
                   Argument{"void_ratio", a[Given::void_ratio]},
                   stress_argument(a, Given::pressure, Given::stress_v, Given::stress_h, true),
                   stress_argument(a, Given::pressure, Given::stress_v, Given::stress_h, false),
                   Argument{"fabric_anisotropy", 0.0},
                   Argument{"tangential_ratio", contact::mindlin_stiffness_ratio(law.grain().poisson_ratio)},
                   Argument{"relative_error", a[Given::relative_error]}};
  if (a.given(Given::fabric))
    out.arguments[Column::fabric].value = a[Given::fabric];
  if (a.given(Given::tangential_ratio))
    out.arguments[Column::tangential_ratio].value = a[Given::tangential_ratio];
  for (std::size_t k = 0; k < inverse::quantities().size(); ++k)
    if (a.given(Given::quantities + k)) {
      out.arguments.push_back({inverse::quantities()[k].key, a[Given::quantities + k]});
      out.given.push_back(inverse::quantities()[k].quantity);
    }
  return out;
}

/// An answer with the state that predictions begin from.
struct Answer {
  InferenceAnswer found;
  effective::State first;
};

py::object infer(const Arguments& a) {
  const auto& law = a.as<const contact::NormalLaw&>(Given::law, "a contact law");
  effective::State state{.law = law};
  if (a.given(Given::contact_means))
    state.contacts = a.as<sizes::ContactMeans>(Given::contact_means, "ContactMeans");
  inverse::InferenceOptions options;
  if (a.given(Given::grain_density))
    options.grain_density = number_of("grain_density", a[Given::grain_density]);
  if (a.given(Given::pore_density))
    options.pore_density = number_of("pore_density", a[Given::pore_density]);
  if (a.given(Given::rattlers))
    options.rattler_fraction = number_of("rattler_fraction", a[Given::rattlers]);
  if (a.given(Given::growth))
    options.growth = inverse::growth_rule_of(a.text(Given::growth));
  if (a.given(Given::contacts))
    options.contacts = inverse::unknown_contacts(a.text(Given::contacts));
  const MeasuredColumns measured = columns_of(a, law);
  const Columns columns(measured.arguments);
  std::vector<inverse::Observation> measurements;
  columns.for_each([&](std::size_t, const double* x) {
    state.radius = x[Column::radius];
    state.void_ratio = x[Column::void_ratio];
    state.stress_v = x[Column::stress_v];
    state.stress_h = x[Column::stress_h];
    state.fabric_anisotropy = x[Column::fabric];
    state.tangential_ratio = x[Column::tangential_ratio];
    for (std::size_t k = 0; k < measured.given.size(); ++k)
      if (const double value = x[Column::quantities + k]; !std::isnan(value))
        measurements.push_back({measured.given[k], {value, x[Column::relative_error] * value}, state});
  });
  if (measurements.empty())
    throw InvalidArgument("nothing is measured: give G, G_hh, K, V_s, V_s_hh, V_p or V_p_h");
  Answer answer{.found = {}, .first = measurements.front().state};
  if (a.given(Given::uncertainty))
    options.inputs =
        shared_inputs(a.as<std::map<std::string, double>>(Given::uncertainty,
                                                          "a dict of inputs and their standard deviations"),
                      answer.first, options.grain_density.value_or(0), a.given(Given::tangential_ratio));
  try {
    const py::gil_scoped_release unlocked;
    answer.found = inverse::infer(measurements, options);
  } catch (const InvalidArgument& error) {
    std::vector<Argument> typed = measured.arguments;
    if (a.given(Given::pressure))
      typed.push_back({"pressure", 0.0, "stress"}); // the mean of all three
    throw as_typed(error, typed);
  }
  return py::cast(std::move(answer));
}

/// What follows of an answer: `together`, or the reason why there is nothing.
const Inference& together(const Answer& answer) {
  if (answer.found.together)
    return *answer.found.together;
  std::string why = "no contact number explains what was measured";
  for (const std::string& note : answer.found.validity.notes)
    why += "; " + note;
  throw NotConverged(why);
}

struct MeasuredRow {
  double value = std::numeric_limits<double>::quiet_NaN();
  double standard_error = std::numeric_limits<double>::quiet_NaN();
};

py::object predict(const Answer& answer, const std::string& quantity, const py::object& pressure,
                   const py::object& vertical, const py::object& horizontal,
                   const py::object& given_void_ratio, const std::string& specimen) {
  const Inference& inference = together(answer);
  const inverse::Quantity asked = inverse::quantity_of(quantity);
  const inverse::AskedPacking which = inverse::asked_packing_of(specimen);
  PyObject* const stresses[] = {pressure.ptr(), vertical.ptr(), horizontal.ptr()};
  static const KeywordFunction function{"predict", {{"pressure"}, {"stress_v"}, {"stress_h"}}, nullptr, ""};
  const Arguments arguments(function, stresses);
  const bool own_void_ratio = given_void_ratio.is_none();
  const Argument columns[] = {
      stress_argument(arguments, 0, 1, 2, true), stress_argument(arguments, 0, 1, 2, false),
      own_void_ratio ? Argument{"void_ratio", 0.0} : Argument{"void_ratio", given_void_ratio}};
  return py::cast(answer_rows(columns, false, MeasuredRow{}, [&](const double* x, Notes&) {
    effective::State at = answer.first;
    at.stress_v = x[0];
    at.stress_h = x[1];
    at.void_ratio = own_void_ratio ? inference.void_ratio_at((x[0] + 2 * x[1]) / 3) : x[2];
    const Measured found = inference.predict(asked, at, which);
    return MeasuredRow{found.value, found.standard_error};
  }));
}

inverse::InferredPacking contacts(const Answer& answer) { return together(answer).packing(answer.first); }

void bind_answer(py::module_& module) {
  py::class_<Answer>(module, "Inference", R"(What measurements say of the contacts of a packing.

Its numbers raise NotConverged where no contact number explains what was measured; `explained` tells.)")
      .def_property_readonly(
          "explained", [](const Answer& a) { return a.found.together.has_value(); },
          "Whether any contact number explains what was measured.")
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
          "z* that each measurement implies by itself; None where no contact number explains it.")
      .def_property_readonly(
          "deviations",
          [](const Answer& a) {
            std::vector<double> out;
            for (const inverse::FittedObservation& one : together(a).measurements())
              out.push_back(one.deviation);
            return out;
          },
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
           py::arg("void_ratio") = py::none(), py::arg("specimen") = "same",
           R"(A quantity of the packing at other stresses, with its standard error.

Parameters
----------
quantity : str
    G, G_hh, K, V_s, V_s_hh, V_p or V_p_h.
pressure : array_like, optional
    Isotropic stress [Pa], instead of stress_v and stress_h.
stress_v, stress_h : array_like, optional
    Compression positive [Pa].
void_ratio : array_like, optional
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
    Where no contact number explains what was measured.
)")
      .def("__repr__", [](const Answer& a) {
        if (!a.found.together)
          return std::string("<Inference: no contact number explains what was measured>");
        const Measured z = contacts(a).mechanical_coordination_number;
        return "Inference(mechanical_coordination_number=" +
               std::string(py::str("{:.3f} +- {:.3f})").format(z.value, z.standard_error));
      });
}

} // namespace

void bind_inverse(py::module_& module) {
  auto rows =
      result_class<MeasuredRow>(module, "MeasuredRows", "Numbers with standard errors, in their unit.");
  show_member<MeasuredRow>(rows, "value", offsetof(MeasuredRow, value), "The number.");
  show_member<MeasuredRow>(rows, "standard_error", offsetof(MeasuredRow, standard_error),
                           "Its standard error.");
  bind_answer(module);
  std::vector<Keyword> keywords{{"law"},
                                {"radius"},
                                {"void_ratio"},
                                {"pressure", "None"},
                                {"stress_v", "None"},
                                {"stress_h", "None"},
                                {"fabric_anisotropy", "0.0"},
                                {"tangential_ratio", "None"},
                                {"contact_means", "None"},
                                {"relative_error"},
                                {"grain_density", "None"},
                                {"pore_density", "0.0"},
                                {"rattler_fraction", "None"},
                                {"growth", "'packings'"},
                                {"contacts", "'given'"},
                                {"uncertainty", "None"}};
  for (const inverse::QuantityRow& row : inverse::quantities())
    keywords.push_back({row.key, "None"});
  define(module, {"infer", keywords, &infer,
                  std::string() + R"(The contacts that measured moduli or wave speeds imply.

All measurements are of one packing, and are fitted together. Calibrate once, predict elsewhere.

Parameters
----------
law : NormalLaw
    Normal contact of two grains, as sphere() makes it.
radius : float
    R > 0 of a grain [m].
void_ratio : array_like
    e > 0 at each measurement [1].
pressure : array_like, optional
    Isotropic stress [Pa], instead of stress_v and stress_h.
stress_v, stress_h : array_like, optional
    Compression positive [Pa].
fabric_anisotropy : array_like
    a of E(gamma; a) [1].
tangential_ratio : array_like, optional
    k_t/k_n [1]; without it mindlin_stiffness_ratio of the law's material.
contact_means : ContactMeans, optional
    Of unequal grains; without it those of equal ones.
relative_error : array_like
    Standard errors of the measurements over their values [1].
grain_density : float, optional
    Of the grains' solid [kg/m3]; wave speeds need it.
pore_density : float
    Of what fills the pores [kg/m3].
rattler_fraction : float, optional
    x_0 at the first measurement, where it is known [1].
growth : str
    How z* follows the pressure: "packings", as in granum's own packings, "fixed", or "fitted".
contacts : str
    What is asked for besides z*, in the place of smooth spheres: "given" (nothing: the law stays), "rough"
    (roughness), or "power-law" (softness, which is k_n over Hertz', and alpha).
uncertainty : dict, optional
    Standard deviations of what all measurements share, by the names of numbers above, grain_shear_modulus and
    grain_poisson_ratio: {"void_ratio": 0.01} [their units]; without it none.
G, G_hh, K : array_like, optional
    Measured moduli [Pa]; NaN where there is none.
V_s, V_s_hh, V_p, V_p_h : array_like, optional
    Measured wave speeds, vertical or horizontal [m/s]; NaN where there is none.

Returns
-------
Inference

Raises
------
InvalidArgument
    Without measurements, for numbers out of range, for a speed without grain_density.
NotConverged
    If least squares fail.
)" +
                      notes("z* by weighted least squares in ln of the measured values, through rung 3; "
                            "errors to first order.",
                            "inverse::infer", "inverse/inference.hpp")});
}

} // namespace granum::python
