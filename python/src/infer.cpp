// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cmath>
#include <cstddef>
#include <optional>

#include <granum/core/error.hpp>
#include <granum/elastic/waves.hpp>
#include <granum/inverse/inference.hpp>
#include <granum/inverse/sand_inference.hpp>

#include "inverse.hpp"
#include "question.hpp"
#include "shared_keywords.hpp"

namespace granum::python {

namespace {

using estimate::Input;
using estimate::InputValues;

/// The keywords of infer, in their order.
std::vector<Keyword> infer_keywords() {
  std::vector<Keyword> all{
      law_keyword(),
      of_input(Input::radius, "float"),
      of_input(Input::void_ratio),
      of_input(Input::pressure).or_none(),
      of_input(Input::stress_v).or_none(),
      of_input(Input::stress_h).or_none(),
      of_input(Input::fabric).or_number(0),
      tangential_ratio_keyword("array_like"),
      of_input(Input::rolling).or_number(0),
      contact_means_keyword(),
      column("relative_error", "Standard errors of the measurements over their values [1]."),
      of_input(Input::grain_density, "float").or_none(),
      with_default("pore_density", "0.0", "float",
                   "Of the fluid in the pores of spheres, if it is not water [kg/m3]."),
      optional("rattler_fraction", "float", "x_0 of spheres at the first measurement, if known [1]."),
      optional("growth", "str",
               "Growth of z* of spheres with pressure: \"packings\" (as in granum's own packings; the "
               "default),\n    \"fixed\" or \"fitted\". Growth of G of a sand: \"sand\" (as in measured "
               "sands; the default) or\n    \"fitted\"."),
      with_default("contacts", "'given'", "str",
                   "Of spheres, properties of the contacts that are inferred besides z*: \"given\" (none), "
                   "\"rough\"\n    (roughness), or \"power-law\" (softness, k_n over that of Hertz, and "
                   "alpha)."),
      optional("uncertainty", "dict",
               "Standard deviations of the inputs common to all measurements of spheres, by their "
               "names,\n    grain_shear_modulus and grain_poisson_ratio: {\"void_ratio\": 0.01} [their "
               "units]; none by default."),
      of_input(Input::saturation).or_number(0),
      optional(
          "grain_shape", "str",
          "\"sphere\", the model, or \"sand\", what was measured on sands. By default \"sand\" if a number "
          "or the\n    name of a sand is given, else \"sphere\".")};
  all = all + sand_keywords();
  for (const inverse::QuantityRow& row : inverse::quantities()) {
    const bool speed = row.speed;
    all.push_back(optional(row.key, "array_like",
                           std::string("Measured ") + (speed ? "wave speed [m/s]" : "modulus [Pa]") +
                               "; NaN where there is none."));
  }
  return all;
}

/// Where the keywords are; those that are numbers of a sand, and then quantities, follow.
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
    rolling,
    contact_means,
    relative_error,
    grain_density,
    pore_density,
    rattlers,
    growth,
    contacts,
    uncertainty,
    saturation,
    grain_shape,
    sand,
    numbers_of_sand,
    quantities = numbers_of_sand + std::size(python::numbers_of_sand)
  };
};

/// Columns of the state, and of the error of what is measured there; quantities follow.
struct Column {
  enum : std::size_t {
    radius,
    void_ratio,
    stress_v,
    stress_h,
    fabric,
    tangential_ratio,
    rolling,
    saturation,
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
                   Argument{"rolling", 0.0},
                   Argument{"saturation", 0.0},
                   Argument{"relative_error", a[Given::relative_error]}};
  if (a.given(Given::fabric))
    out.arguments[Column::fabric].value = a[Given::fabric];
  if (a.given(Given::tangential_ratio))
    out.arguments[Column::tangential_ratio].value = a[Given::tangential_ratio];
  if (a.given(Given::rolling))
    out.arguments[Column::rolling].value = a[Given::rolling];
  if (a.given(Given::saturation))
    out.arguments[Column::saturation].value = a[Given::saturation];
  for (std::size_t k = 0; k < inverse::quantities().size(); ++k)
    if (a.given(Given::quantities + k)) {
      out.arguments.push_back({inverse::quantities()[k].key, a[Given::quantities + k]});
      out.given.push_back(inverse::quantities()[k].quantity);
    }
  return out;
}

std::vector<inverse::Observation> measurements_of(const Arguments& a, const contact::NormalLaw& law,
                                                  const MeasuredColumns& measured) {
  effective::State state{.law = law};
  if (a.given(Given::contact_means))
    state.contacts = a.as<sizes::ContactMeans>(Given::contact_means, "ContactMeans");
  const Columns columns(measured.arguments);
  std::vector<inverse::Observation> measurements;
  columns.for_each([&](std::size_t, const double* x) {
    state.radius = x[Column::radius];
    state.void_ratio = x[Column::void_ratio];
    state.stress_v = x[Column::stress_v];
    state.stress_h = x[Column::stress_h];
    state.fabric_anisotropy = x[Column::fabric];
    state.tangential_ratio = x[Column::tangential_ratio];
    state.rolling = x[Column::rolling];
    for (std::size_t k = 0; k < measured.given.size(); ++k)
      if (const double value = x[Column::quantities + k]; !std::isnan(value))
        measurements.push_back(
            {measured.given[k],
             {value, x[Column::relative_error] * value},
             state,
             a.given(Given::saturation) ? std::optional(x[Column::saturation]) : std::nullopt});
  });
  if (measurements.empty())
    throw InvalidArgument("nothing is measured: give G, G_hh, K, V_s, V_s_hh, V_p or V_p_h");
  return measurements;
}

/// What is known of the packing besides its measurements: its law, material and sand.
InputValues values_of(const Arguments& a, const inverse::Observation& measured) {
  const effective::State& first = measured.state;
  InputValues values = values_of_law(first.law);
  values.give(Input::radius, first.radius);
  values.give(Input::void_ratio, first.void_ratio);
  values.contact_means = first.contacts;
  values.set_stresses({first.stress_v, first.stress_h});
  for (const auto& [input, place, number] :
       {std::tuple{Input::fabric, Given::fabric, first.fabric_anisotropy},
        {Input::tangential_ratio, Given::tangential_ratio, first.tangential_ratio},
        {Input::rolling, Given::rolling, first.rolling}})
    if (a.given(place))
      values.give(input, number);
  if (const std::optional<double> density = a.number_if_given(Given::grain_density))
    values.give(Input::grain_density, *density);
  if (measured.saturation)
    values.give(Input::saturation, *measured.saturation);
  give_word(values, Input::grain_shape, a, Given::grain_shape);
  give_word(values, Input::sand, a, Given::sand);
  for (std::size_t k = 0; k < std::size(numbers_of_sand); ++k)
    if (const std::optional<double> number = a.number_if_given(Given::numbers_of_sand + k))
      values.give(numbers_of_sand[k], *number);
  return completed(std::move(values));
}

inverse::InferenceOptions options_of(const Arguments& a, const InputValues& values) {
  if (a.given(Given::saturation) && a.given(Given::pore_density))
    throw py::type_error("saturation and pore_density say the same: give one");
  inverse::InferenceOptions options;
  options.grain_density = values.if_given(Input::grain_density);
  options.pore_density = a.number_if_given(Given::pore_density)
                             .value_or(elastic::water_density * values.within(Input::saturation));
  options.rattler_fraction = a.number_if_given(Given::rattlers);
  if (a.given(Given::growth))
    options.growth = inverse::growth_rule_of(a.text(Given::growth));
  if (a.given(Given::contacts))
    options.contacts = inverse::unknown_contacts(a.text(Given::contacts));
  const estimate::Deviations stated = deviations_of(a, Given::uncertainty, inverse::shared_rows(values),
                                                    "an input common to all measurements");
  std::vector<estimate::UncertainInput> uncertain = uncertain_inputs(values, stated);
  std::erase_if(uncertain, [](const estimate::UncertainInput& one) { return one.assumed; });
  options.inputs = inverse::shared_inputs(values, uncertain);
  return options;
}

inverse::SandGrowth sand_growth_of(const std::string& growth) {
  if (growth == "sand")
    return inverse::SandGrowth::measured;
  if (growth == "fitted")
    return inverse::SandGrowth::fitted;
  throw InvalidArgument("growth of a sand is sand or fitted, not " + growth);
}

py::object infer_spheres(const Arguments& a, const InputValues& values,
                         const std::vector<inverse::Observation>& measurements) {
  constexpr std::size_t d50 = Given::quantities - 1;
  if (a.given(d50))
    throw py::type_error("d50 is a number of a sand; spheres have a radius");
  if (a.given(Given::growth) && a.text(Given::growth) == "sand")
    throw InvalidArgument("growth sand is that of sands: give sand or grain_shape");
  return sphere_inference(measurements, options_of(a, values));
}

py::object infer_sand(const Arguments& a, const InputValues& values,
                      const std::vector<inverse::Observation>& measurements) {
  for (const std::size_t of_spheres :
       {Given::pore_density, Given::rattlers, Given::contacts, Given::uncertainty})
    if (a.given(of_spheres))
      throw py::type_error(std::string(a.name(of_spheres)) + " belongs to spheres: a sand takes none");
  const estimate::Question sand{.state = measurements.front().state,
                                .grain_density = values.if_given(Input::grain_density),
                                .saturation = values.within(Input::saturation),
                                .grain_shape = estimate::GrainShape::sand,
                                .sand = sand_of(values)};
  return sand_inference(measurements, sand,
                        a.given(Given::growth) ? sand_growth_of(a.text(Given::growth))
                                               : inverse::SandGrowth::measured);
}

/// The arguments that were given, by their names, to make the result again from a pickle; arrays as they are
/// now.
py::dict call_of(const Arguments& a) {
  py::dict call;
  for (std::size_t k = 0; k < a.function().keywords.size(); ++k)
    if (a.given(k))
      call[a.name(k)] = py::isinstance<py::array>(a[k]) ? py::object(a[k].attr("copy")())
                                                        : py::reinterpret_borrow<py::object>(a[k]);
  return call;
}

py::object infer(const Arguments& a) {
  const auto& law = a.as<const contact::NormalLaw&>(Given::law, "a contact law");
  const MeasuredColumns measured = columns_of(a, law);
  const std::vector<inverse::Observation> measurements = measurements_of(a, law, measured);
  try {
    const InputValues values = values_of(a, measurements.front());
    py::object found = known_shape(values) == estimate::GrainShape::sand
                           ? infer_sand(a, values, measurements)
                           : infer_spheres(a, values, measurements);
    found.attr("_call") = call_of(a);
    return found;
  } catch (const InvalidArgument& error) {
    std::vector<Argument> typed = measured.arguments;
    if (a.given(Given::pressure))
      typed.push_back({"pressure", 0.0, "stress"}); // the mean of all three
    throw as_typed(error, typed);
  }
}

} // namespace

void bind_infer(py::module_& module) {
  define(module, "infer", infer_keywords(),
         {.summary =
              "The contacts that measured moduli or wave speeds imply; of a sand, its own law.\n\nAll "
              "measurements are of one packing or one sand, and are fitted together. Calibrate once, "
              "predict\nelsewhere. Spheres are those of the model; a sand follows the laws measured on "
              "sands, and `law` moves its\ncontact_softness alone.",
          .returns = "Inference or SandInference\n    The latter of a sand.",
          .refuses = "Without measurements, for numbers out of range, for a speed without grain_density.",
          .remarks =
              "z* by weighted least squares in ln of the measured values, through rung 3; errors to "
              "first order.\nA sand: inverse::infer_sand of inverse/sand_inference.hpp, by the pooled law "
              "of sands. [Lo2021]",
          .function = "inverse::infer",
          .header = "inverse/inference.hpp",
          .more_errors = "TypeError\n    For a keyword of spheres beside a sand.\nNotConverged\n    If least "
                         "squares fail.\n"},
         &infer);
}

} // namespace granum::python
