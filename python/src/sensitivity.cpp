// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstddef>
#include <limits>

#include <granum/core/measured.hpp>
#include <granum/core/number.hpp>
#include <granum/effective/ladder.hpp>
#include <granum/effective/sensitivity/uncertainty.hpp>

#include "bindings.hpp"
#include "docstrings.hpp"
#include "estimate.hpp"
#include "state.hpp"

namespace granum::python {

namespace {

using effective::Input;

constexpr std::pair<const char*, Input> inputs[] = {
    {"mean_stress", Input::mean_stress},
    {"stress_v", Input::stress_v},
    {"stress_h", Input::stress_h},
    {"coordination_number", Input::coordination_number},
    {"void_ratio", Input::void_ratio},
    {"fabric_anisotropy", Input::fabric_anisotropy},
    {"alpha", Input::alpha},
    {"grain_shear_modulus", Input::grain_shear_modulus},
    {"grain_poisson_ratio", Input::grain_poisson_ratio},
    {"grain_poisson_ratio_mindlin", Input::grain_poisson_ratio_mindlin},
    {"tangential_ratio", Input::tangential_ratio},
    {"radius", Input::radius},
    {"mechanical_coordination_number", Input::mechanical_coordination_number}};
static_assert(std::size(inputs) == effective::input_count);

const std::string rung_and_modulus = R"(rung : int or str
    0 to 3, or isotropic, fabric, directional, relaxed, uniform_stress.
modulus : str
    K, G_hh, G_vh, E_v, E_h, C11, C33, C12 or C13.
)";

const std::string refused = raises_invalid(
    "For numbers that no packing can have; arrays: under strict. For another rung or modulus.");

// ---- exponents

struct ExponentRow {
  double stress_v = std::numeric_limits<double>::quiet_NaN();
  double stress_h = std::numeric_limits<double>::quiet_NaN();
};

py::object exponents(const Arguments& a) {
  const StateArguments arguments(a);
  const effective::Rung& rung = closed_form_of(a[state_keyword_count]);
  const effective::Modulus modulus = modulus_of(a.text(state_keyword_count + 1));
  return py::cast(
      answer_rows(arguments.columns(), arguments.strict(), ExponentRow{}, [&](const double* x, Notes&) {
        const auto found = effective::exponents(rung, arguments.inputs(x), modulus);
        return found ? ExponentRow{found->stress_v, found->stress_h} : ExponentRow{};
      }));
}

void bind_exponents(py::module_& module) {
  auto type = result_class<ExponentRow>(module, "Exponents", "How a modulus grows with the stresses.");
  show_member<ExponentRow>(type, "stress_v", offsetof(ExponentRow, stress_v), "d ln X/d ln stress_v [1].");
  show_member<ExponentRow>(type, "stress_h", offsetof(ExponentRow, stress_h), "d ln X/d ln stress_h [1].");
  type.def_property_readonly(
      "sum",
      [](const Rows<ExponentRow>& rows) {
        return computed(rows, [](const ExponentRow& row) {
          return effective::StressExponents{row.stress_v, row.stress_h}.sum();
        });
      },
      "s = d ln X/d ln p at constant stress ratio [1].");
  define(module, {"exponents", state_keywords({{"rung"}, {"modulus"}}), &exponents,
                  std::string("Exponents of a modulus at frozen contacts: C_n, z* and a do not grow.\n") +
                      state_parameters + rung_and_modulus + R"(
Returns
-------
Exponents
    NaN where the modulus vanishes whatever the stress.
)" + refused +
                      notes("Differentiated exactly under the integral. [Chung2014]", "effective::exponents",
                            "effective/rungs.hpp")});
}

// ---- gradients

struct GradientRow {
  double value = std::numeric_limits<double>::quiet_NaN();
  double standard_error = std::numeric_limits<double>::quiet_NaN();
  std::array<double, effective::input_count> by;

  GradientRow() { by.fill(std::numeric_limits<double>::quiet_NaN()); }
};

py::object gradient(const Arguments& a) {
  const StateArguments arguments(a);
  const effective::Rung& rung = closed_form_of(a[state_keyword_count]);
  const effective::Modulus modulus = modulus_of(a.text(state_keyword_count + 1));
  return py::cast(
      answer_rows(arguments.columns(), arguments.strict(), GradientRow{}, [&](const double* x, Notes&) {
        const effective::CalibratedGradient found = effective::gradient(rung, arguments.inputs(x), modulus);
        GradientRow row;
        row.value = found.gradient.value;
        row.standard_error = found.standard_error;
        row.by = found.gradient.by;
        return row;
      }));
}

void bind_gradient(py::module_& module) {
  auto type = result_class<GradientRow>(module, "Gradient", R"(A modulus and its exact derivatives.

Each input varies alone, except mean_stress, which moves both stresses at their ratio, and
grain_poisson_ratio_mindlin, which takes k_t/k_n along.)");
  show_member<GradientRow>(type, "value", offsetof(GradientRow, value), "The modulus [Pa].");
  show_member<GradientRow>(type, "standard_error", offsetof(GradientRow, standard_error),
                           "Of the calibration of rung 3; 0 without one [Pa].");
  for (const auto& [name, input] : inputs)
    show_member<GradientRow>(type, name,
                             offsetof(GradientRow, by) + sizeof(double) * static_cast<std::size_t>(input),
                             "Derivative by this input [Pa over its unit].");
  define(module,
         {"gradient", state_keywords({{"rung"}, {"modulus"}}), &gradient,
          std::string("A modulus with its exact derivatives by every input.\n") + state_parameters +
              rung_and_modulus + "\nReturns\n-------\nGradient\n" + refused +
              notes("Value and derivatives are one text, evaluated with dual numbers; rung 3 also by z*.",
                    "effective::gradient", "effective/rungs.hpp")});
}

// ---- uncertainty

effective::Deviations deviations_of(const Arguments& a) {
  effective::Deviations out;
  for (const auto& [name, deviation] : a.as<std::map<std::string, double>>(
           state_keyword_count + 2, "a dict of inputs and their standard deviations")) {
    const auto* known = std::find_if(std::begin(inputs), std::end(inputs),
                                     [name = name](const auto& input) { return name == input.first; });
    if (known == std::end(inputs)) {
      std::string all;
      for (const auto& input : inputs)
        all += std::string(all.empty() ? "" : ", ") + input.first;
      throw InvalidArgument("deviations: " + name + " is none of the inputs " + all);
    }
    out[known->second] = deviation;
  }
  return out;
}

/// The models of the rungs that are uniform fields.
effective::Model model_of(const effective::Rung& rung) {
  using effective::RungName;
  effective::Model model;
  if (rung.name == RungName::isotropic || rung.name == RungName::fabric)
    model.forces = effective::ContactForces::mean;
  if (rung.name == RungName::uniform_stress)
    model.hypothesis = effective::Hypothesis::uniform_stress;
  return model;
}

py::object uncertainty(const Arguments& a) {
  effective::RungInputs packing = StateArguments(a).one_packing("uncertainty");
  const effective::Rung& rung = closed_form_of(a[state_keyword_count]);
  const effective::Modulus modulus = modulus_of(a.text(state_keyword_count + 1));
  const effective::Deviations deviations = deviations_of(a);
  effective::Sampling sampling;
  if (a.given(state_keyword_count + 3))
    sampling.draws = a.as<std::size_t>(state_keyword_count + 3, "a whole number, 0 or more");
  if (a.given(state_keyword_count + 4))
    sampling.seed = a.as<std::uint64_t>(state_keyword_count + 4, "a whole number, 0 or more");
  const py::gil_scoped_release unlocked;
  effective::Uncertainty out;
  if (rung.needs_coordination) {
    (void)effective::answer(rung, packing); // says so where z* is missing
    out = effective::relaxed_uncertainty(packing.state, *packing.mechanical_coordination_number, modulus,
                                         deviations, sampling);
  } else {
    if (!rung.needs_fabric)
      packing.state.fabric_anisotropy = 0;
    out = effective::uncertainty(packing.state, model_of(rung), modulus, deviations, sampling);
  }
  const py::gil_scoped_acquire locked;
  return py::cast(std::move(out));
}

void bind_uncertainty(py::module_& module) {
  using effective::Band;
  py::class_<Band>(module, "Band", "Distribution of a modulus over the accepted draws.")
      .def_readonly("mean", &Band::mean, "[Pa]")
      .def_readonly("deviation", &Band::deviation, "Standard deviation [Pa].")
      .def_readonly("low", &Band::low, "16 % of the draws are below [Pa].")
      .def_readonly("median", &Band::median, "[Pa]")
      .def_readonly("high", &Band::high, "84 % of the draws are below [Pa].");
  using effective::Uncertainty;
  py::class_<Uncertainty>(module, "Uncertainty", "A modulus and what uncertain inputs make of it.")
      .def_readonly("value", &Uncertainty::value, "The modulus at the inputs as given [Pa].")
      .def_property_readonly(
          "deviation", [](const Uncertainty& u) { return u.first_order.deviation; },
          "Standard deviation to first order [Pa].")
      .def_property_readonly(
          "calibration", [](const Uncertainty& u) { return u.first_order.calibration; },
          "The estimate's own standard error [Pa].")
      .def_property_readonly(
          "contributions",
          [](const Uncertainty& u) {
            py::dict out;
            for (const auto& [name, input] : inputs)
              if (const double change = u.first_order.contributions[static_cast<std::size_t>(input)];
                  change != 0)
                out[name] = change;
            return out;
          },
          "Change of the modulus with one deviation of each uncertain input [Pa].")
      .def_property_readonly(
          "shares",
          [](const Uncertainty& u) {
            py::dict out;
            for (const auto& [name, input] : inputs)
              if (const double change = u.first_order.contributions[static_cast<std::size_t>(input)];
                  change != 0)
                out[name] = u.first_order.share(change);
            return out;
          },
          "Of the variance, what each uncertain input makes [1].")
      .def_readonly("sampled", &Uncertainty::sampled, "Distribution over draws of the inputs.")
      .def_readonly("rejected", &Uncertainty::rejected, "Draws that no packing can have.");
  define(module,
         {"uncertainty",
          state_keywords({{"rung"}, {"modulus"}, {"deviations"}, {"draws", "None"}, {"seed", "None"}}),
          &uncertainty,
          std::string("How uncertain inputs make a modulus of one packing uncertain.\n") + state_parameters +
              rung_and_modulus + R"(deviations : dict
    Standard deviations by the names of the inputs, as Gradient has them: {"void_ratio": 0.01} [their units].
draws, seed : int, optional
    Of the sample.

Returns
-------
Uncertainty

Raises
------
InvalidArgument
    For numbers that no packing can have, or a deviation of what is no input.
TypeError
    For arrays.
)" +
              notes("To first order [JCGM2008a], and by draws of the inputs [JCGM2008b].",
                    "effective::uncertainty", "effective/sensitivity/uncertainty.hpp")});
}

// ---- the ladder

enum : std::size_t { tolerance_at = state_keyword_count, z_error_at, rattler_error_at, fabric_error_at };

py::object estimate(const Arguments& a) {
  const StateArguments arguments(a);
  const effective::RungInputs packing = arguments.one_packing("estimate");
  effective::KnownPacking known{.state = packing.state};
  constexpr std::size_t z_at = 9, rattlers_at = 10;
  if (a.given(z_at))
    known.mechanical_coordination_number = Measured{number_of("mechanical_coordination_number", a[z_at])};
  if (a.given(rattlers_at))
    known.rattler_fraction = Measured{number_of("rattler_fraction", a[rattlers_at])};
  if (a.given(z_error_at) && known.mechanical_coordination_number)
    known.mechanical_coordination_number->standard_error = number_of("coordination_error", a[z_error_at]);
  if (a.given(rattler_error_at) && known.rattler_fraction)
    known.rattler_fraction->standard_error = number_of("rattler_error", a[rattler_error_at]);
  if (a.given(fabric_error_at))
    known.fabric_standard_error = number_of("fabric_standard_error", a[fabric_error_at]);
  else if (a.is_none(fabric_error_at))
    known.fabric_standard_error.reset();
  return py::cast(effective::estimate(known, number_of("tolerance", a[tolerance_at])));
}

const char* word(effective::RungVerdict verdict) {
  using enum effective::RungVerdict;
  switch (verdict) {
  case chosen:
    return "chosen";
  case cheaper_does:
    return "cheaper_does";
  case beyond_tolerance:
    return "beyond_tolerance";
  case error_unknown:
    return "error_unknown";
  default:
    return "inputs_missing";
  }
}

void bind_ladder(py::module_& module) {
  py::class_<Measured>(module, "Measured", "A number and its standard error, in its unit.")
      .def_readonly("value", &Measured::value, "The number, in its unit.")
      .def_readonly("standard_error", &Measured::standard_error, "Its standard error, in the same unit.")
      .def("__repr__", [](const Measured& m) {
        return "Measured(" + exact_text(m.value) + " +- " + exact_text(m.standard_error) + ")";
      });
  using effective::RungAssessment;
  py::class_<RungAssessment>(module, "RungAssessment", "One rung of the ladder for one packing.")
      .def_readonly("rung", &RungAssessment::rung, "Its number.")
      .def_readonly("title", &RungAssessment::title, "In a few words.")
      .def_readonly("typical_time", &RungAssessment::typical_time, "Of one evaluation [s].")
      .def_readonly("missing", &RungAssessment::missing, "Inputs that it needs and has not.")
      .def_property_readonly(
          "estimate",
          [](const RungAssessment& r) -> py::object {
            if (!r.stiffness)
              return py::none();
            return estimate_object(
                {.stiffness = *r.stiffness, .validity = {}, .relative_error = r.relative_error});
          },
          "Stiffness and stated errors; None where an input is missing.")
      .def_property_readonly("largest_error", &RungAssessment::largest_error,
                             "Of the stated errors of K, G_hh and G_vh [1]; None where none is stated.")
      .def_readonly("error_source", &RungAssessment::error_source, "Where its stated errors come from.")
      .def_property_readonly(
          "verdict", [](const RungAssessment& r) { return word(r.verdict); },
          "chosen, cheaper_does, beyond_tolerance, error_unknown or inputs_missing.")
      .def_readonly("reason", &RungAssessment::reason, "The verdict in words.");
  using effective::LadderEstimate;
  py::class_<LadderEstimate>(module, "LadderEstimate", "The ladder for one packing, and the rung to take.")
      .def_readonly("tolerance", &LadderEstimate::tolerance, "[1]")
      .def_readonly("tolerance_met", &LadderEstimate::tolerance_met,
                    "Whether the stated error of the choice is within it.")
      .def_readonly("mechanical_coordination_number", &LadderEstimate::mechanical_coordination_number,
                    "z* that the errors are stated with.")
      .def_readonly("coordination_estimated", &LadderEstimate::coordination_estimated,
                    "z* comes from C_n alone.")
      .def_property_readonly(
          "rungs",
          [](const LadderEstimate& ladder) {
            return std::vector<RungAssessment>(ladder.rungs.begin(), ladder.rungs.end());
          },
          "Rungs 0 to 5; 4 and 5 always lack a packing.")
      .def_property_readonly(
          "choice", [](const LadderEstimate& ladder) { return ladder.choice(); }, "The rung to take.")
      .def_readonly("advice", &LadderEstimate::advice, "Inputs that would allow a better or a cheaper rung.")
      .def_property_readonly(
          "notes", [](const LadderEstimate& ladder) { return ladder.validity.notes; },
          "Remarks on numbers outside the range of a formula, a sentence each.");
  define(module, {"estimate",
                  state_keywords({{"tolerance"},
                                  {"coordination_error", "None"},
                                  {"rattler_error", "None"},
                                  {"fabric_standard_error", "0.0"}}),
                  &estimate,
                  std::string("The cheapest rung whose stated error fits a tolerance, for one packing.\n") +
                      state_parameters + R"(tolerance : float
    > 0, of the largest stated error among K, G_hh and G_vh [1]: 0.05 for 5 %.
coordination_error, rattler_error : float, optional
    Standard error of mechanical_coordination_number or of rattler_fraction [1]; without it they are exact.
fabric_standard_error : float or None
    Of fabric_anisotropy; None: it was not measured and is an assumption [1].

Returns
-------
LadderEstimate

Raises
------
InvalidArgument
    For numbers that no packing can have.
TypeError
    For arrays.
)" +
                      notes("Stated errors hold those of the rung, and of z*, rattlers and fabric as far as "
                            "they are not exact.",
                            "effective::estimate", "effective/ladder.hpp")});
}

} // namespace

void bind_sensitivity(py::module_& module) {
  bind_exponents(module);
  bind_gradient(module);
  bind_uncertainty(module);
  bind_ladder(module);
}

} // namespace granum::python
