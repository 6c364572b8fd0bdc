// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cmath>
#include <cstddef>
#include <optional>

#include <granum/core/check.hpp>
#include <granum/elastic/saturation.hpp>
#include <granum/inverse/sand_inference.hpp>

#include "docstrings.hpp"
#include "inverse.hpp"
#include "question.hpp"
#include "shared_inputs.hpp"
#include "state.hpp"

namespace granum::python {

namespace {

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
    for (std::size_t k = 0; k < measured.given.size(); ++k)
      if (const double value = x[Column::quantities + k]; !std::isnan(value))
        measurements.push_back({measured.given[k], {value, x[Column::relative_error] * value}, state});
  });
  if (measurements.empty())
    throw InvalidArgument("nothing is measured: give G, G_hh, K, V_s, V_s_hh, V_p or V_p_h");
  return measurements;
}

std::optional<double> number_if_given(const Arguments& a, std::size_t k, const char* name) {
  return a.given(k) ? std::optional(number_of(name, a[k])) : std::nullopt;
}

double saturation_of(const Arguments& a) {
  const double share = number_if_given(a, Given::saturation, "saturation").value_or(0);
  require_closed("saturation", share, 0, 1);
  return share;
}

inverse::InferenceOptions options_of(const Arguments& a, const effective::State& first) {
  inverse::InferenceOptions options;
  options.grain_density = number_if_given(a, Given::grain_density, "grain_density");
  if (a.given(Given::saturation) && a.given(Given::pore_density))
    throw py::type_error("saturation and pore_density say the same: give one");
  options.pore_density = number_if_given(a, Given::pore_density, "pore_density")
                             .value_or(elastic::water_density * saturation_of(a));
  options.rattler_fraction = number_if_given(a, Given::rattlers, "rattler_fraction");
  if (a.given(Given::growth))
    options.growth = inverse::growth_rule_of(a.text(Given::growth));
  if (a.given(Given::contacts))
    options.contacts = inverse::unknown_contacts(a.text(Given::contacts));
  if (a.given(Given::uncertainty))
    options.inputs =
        shared_inputs(a.as<std::map<std::string, double>>(Given::uncertainty,
                                                          "a dict of inputs and their standard deviations"),
                      first, options.grain_density.value_or(0), a.given(Given::tangential_ratio));
  return options;
}

py::object infer_spheres(const Arguments& a, const std::vector<inverse::Observation>& measurements) {
  for (const SandNumber& number : numbers_of_sand)
    if (const std::size_t k = Given::numbers_of_sand + static_cast<std::size_t>(&number - numbers_of_sand);
        a.given(k))
      throw py::type_error(std::string(number.keyword) + " is a number of a sand: give sand or grain_shape");
  if (a.given(Given::growth) && a.text(Given::growth) == "sand")
    throw InvalidArgument("growth sand is that of sands: give sand or grain_shape");
  return sphere_inference(measurements, options_of(a, measurements.front().state));
}

inverse::SandGrowth sand_growth_of(const std::string& growth) {
  if (growth == "sand")
    return inverse::SandGrowth::measured;
  if (growth == "fitted")
    return inverse::SandGrowth::fitted;
  throw InvalidArgument("growth of a sand is sand or fitted, not " + growth);
}

py::object infer_sand(const Arguments& a, const Grains& grains,
                      const std::vector<inverse::Observation>& measurements) {
  constexpr std::pair<std::size_t, const char*> of_spheres[] = {{Given::pore_density, "pore_density"},
                                                                {Given::rattlers, "rattler_fraction"},
                                                                {Given::contacts, "contacts"},
                                                                {Given::uncertainty, "uncertainty"}};
  for (const auto& [k, name] : of_spheres)
    if (a.given(k))
      throw py::type_error(std::string(name) + " belongs to spheres: a sand takes none");
  estimate::Question sand{.state = measurements.front().state,
                          .grain_density = number_if_given(a, Given::grain_density, "grain_density"),
                          .saturation = saturation_of(a),
                          .grain_shape = estimate::GrainShape::sand,
                          .sand = grains.known()};
  for (std::size_t k = 0; k < std::size(numbers_of_sand); ++k)
    if (const auto value = number_if_given(a, Given::numbers_of_sand + k, numbers_of_sand[k].keyword))
      sand.sand.*numbers_of_sand[k].member = value;
  return sand_inference(measurements, sand,
                        a.given(Given::growth) ? sand_growth_of(a.text(Given::growth))
                                               : inverse::SandGrowth::measured);
}

py::object infer(const Arguments& a) {
  const auto& law = a.as<const contact::NormalLaw&>(Given::law, "a contact law");
  const MeasuredColumns measured = columns_of(a, law);
  const std::vector<inverse::Observation> measurements = measurements_of(a, law, measured);
  const Grains grains = grains_of(a, Given::grain_shape, Given::sand);
  try {
    return grains.shape == estimate::GrainShape::sand ? infer_sand(a, grains, measurements)
                                                      : infer_spheres(a, measurements);
  } catch (const InvalidArgument& error) {
    std::vector<Argument> typed = measured.arguments;
    if (a.given(Given::pressure))
      typed.push_back({"pressure", 0.0, "stress"}); // the mean of all three
    throw as_typed(error, typed);
  }
}

} // namespace

void bind_infer(py::module_& module) {
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
                                {"growth", "None"},
                                {"contacts", "'given'"},
                                {"uncertainty", "None"},
                                {"saturation", "0.0"},
                                {"grain_shape", "'sphere'"},
                                {"sand", "None"}};
  for (const SandNumber& number : numbers_of_sand)
    keywords.push_back({number.keyword, "None"});
  for (const inverse::QuantityRow& row : inverse::quantities())
    keywords.push_back({row.key, "None"});
  define(module,
         {"infer", keywords, &infer,
          std::string() + R"(The contacts that measured moduli or wave speeds imply; of a sand, its own law.

All measurements are of one packing or one sand, and are fitted together. Calibrate once, predict elsewhere.
Spheres are those of the model; a sand (`sand`, or grain_shape "sand") follows the laws measured on sands.

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
    Of the solid of the grains [kg/m3]; required for wave speeds.
pore_density : float
    Of the fluid in the pores of spheres, if it is not water [kg/m3].
rattler_fraction : float, optional
    x_0 of spheres at the first measurement, if known [1].
growth : str, optional
    Growth of z* of spheres with pressure: "packings" (as in granum's own packings; the default), "fixed" or
    "fitted". Growth of G of a sand: "sand" (as in measured sands; the default) or "fitted".
contacts : str
    Of spheres, properties of the contacts that are inferred besides z*: "given" (none), "rough" (roughness),
    or "power-law" (softness, k_n over that of Hertz, and alpha).
uncertainty : dict, optional
    Standard deviations of the inputs common to all measurements of spheres, by their names above,
    grain_shear_modulus and grain_poisson_ratio: {"void_ratio": 0.01} [their units]; none by default.
saturation : float
    Share of the pores' volume that is water, in [0, 1] [1].
grain_shape : str
    "sphere", the model, or "sand", what was measured on sands.
sand : str, optional
    A sand by name, "toyoura", see known_sands(); implies grain_shape "sand" where that is not said. The law
    moves contact_softness alone.
uniformity : float, optional
    C_u = d60/d10 of a sand, >= 1 [1].
least_void_ratio, largest_void_ratio : float, optional
    e_min and e_max of a sand [1].
relative_density : float, optional
    D_r of a sand of void_ratio, in [0, 1.2]; its law takes it unless both limits are known [1].
d50 : float, optional
    Of a sand [m].
G, G_hh, K : array_like, optional
    Measured moduli [Pa]; NaN where there is none.
V_s, V_s_hh, V_p, V_p_h : array_like, optional
    Measured wave speeds, vertical or horizontal [m/s]; NaN where there is none.

Returns
-------
Inference or SandInference
    The latter of a sand.

Raises
------
InvalidArgument
    Without measurements, for numbers out of range, for a speed without grain_density.
TypeError
    For a keyword of spheres beside a sand, or the other way round.
NotConverged
    If least squares fail.
)" +
              notes("z* by weighted least squares in ln of the measured values, through rung 3; "
                    "errors to first order. A sand: inverse::infer_sand of inverse/sand_inference.hpp, "
                    "by the pooled law of sands. [Lo2021]",
                    "inverse::infer", "inverse/inference.hpp")});
}

} // namespace granum::python
