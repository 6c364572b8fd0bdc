// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <tuple>

#include <granum/analysis/measure.hpp>
#include <granum/core/error.hpp>

#include "bindings.hpp"
#include "errors.hpp"
#include "packing.hpp"
#include "shared_keywords.hpp"
#include "studies/analyse/materials.hpp"
#include "studies/analyse/measured_frame.hpp"
#include "studies/analyse/overlaps.hpp"
#include "studies/analyse/window.hpp"

namespace granum::python {

namespace {

using studies::MeasuredFrame;

enum : std::size_t {
  packing_at,
  law_at,
  grain_shear_modulus_at,
  grain_poisson_ratio_at,
  materials_at,
  tangential_ratio_at,
  friction_coefficient_at,
  grain_density_at,
  stiffness_from_at,
  network_at,
  prestress_at,
  window_at,
  rolling_stiffness_at,
  twisting_stiffness_at,
};

constexpr std::pair<const char*, packing::StiffnessFrom> sources_of_stiffness[] = {
    {"overlap", packing::StiffnessFrom::overlap},
    {"force", packing::StiffnessFrom::force},
    {"ratio", packing::StiffnessFrom::ratio}};

/// A number, or a pair of a number and its kind.
std::optional<packing::TurningSpring> turning_spring(const Arguments& a, std::size_t at) {
  using Of = packing::TurningSpring::Of;
  if (!a.given(at))
    return std::nullopt;
  if (!py::isinstance<py::str>(a[at]) && !py::isinstance<py::tuple>(a[at]))
    return packing::TurningSpring{.value = a.number(at), .of = Of::normal};
  const bool alone = py::isinstance<py::str>(a[at]);
  const auto [value, of] = alone
                               ? std::pair(0.0, a.text(at))
                               : a.as<std::pair<double, std::string>>(at, "a number, a pair, or 'marshall'");
  static constexpr std::pair<const char*, Of> known[] = {{"angle", Of::angle},
                                                         {"displacement", Of::displacement},
                                                         {"normal", Of::normal},
                                                         {"marshall", Of::marshall}};
  for (const auto& [word, meaning] : known)
    if (of == word && alone == (meaning == Of::marshall))
      return packing::TurningSpring{.value = value, .of = meaning};
  throw InvalidArgument(a.keyword(at).name +
                        " is a number, (number, 'angle'), (number, 'displacement'), (number, 'normal') or "
                        "'marshall'");
}

/// The part of the packing used for the closed forms: the interior, the whole, or three ranges.
std::optional<analysis::Window> window_of(const Arguments& a, const Packing& packing) {
  if (a.is_none(window_at))
    return std::nullopt;
  if (!a.given(window_at) || py::isinstance<py::str>(a[window_at])) {
    if (a.given(window_at) && a.text(window_at) != "auto")
      throw InvalidArgument("window is 'auto', None or three ranges, not " + a.text(window_at));
    const auto interior = studies::interior_window(packing);
    return interior ? std::optional(studies::window_in(packing, *interior)) : std::nullopt;
  }
  using Range = std::optional<std::pair<std::optional<double>, std::optional<double>>>;
  const auto ranges = a.as<std::array<Range, 3>>(window_at, "'auto', None or three ranges (low, high)");
  studies::WindowChoice choice;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (ranges[axis])
      std::tie(choice.low[axis], choice.high[axis]) = *ranges[axis];
  return studies::window_in(packing, choice);
}

studies::MaterialsByType materials_by_type(const Arguments& a) {
  studies::MaterialsByType out;
  for (const auto& [type, material] : a.as<std::map<long, std::pair<double, double>>>(
           materials_at, "a dict of types and their (shear modulus, Poisson's ratio)"))
    out[type] = {material.first, material.second};
  return out;
}

/// The law of all contacts, and the material of their grains.
void take_law(const Arguments& a, std::size_t at, analysis::Given& given) {
  const auto& law = a.as<const contact::NormalLaw&>(at);
  given.law_family = [law](const contact::GrainMaterial& grain, double radius) {
    return law.of(grain, radius);
  };
  given.grain_shear_modulus = law.grain().shear_modulus;
  given.grain_poisson_ratio = law.grain().poisson_ratio;
}

analysis::Given given_of(const Arguments& a, const Packing& packing) {
  analysis::Given given{.grain_shear_modulus = a.number_if_given(grain_shear_modulus_at),
                        .grain_density = a.number_if_given(grain_density_at),
                        .law_assumed = !a.given(law_at),
                        .tangential_ratio = a.number_if_given(tangential_ratio_at),
                        .friction_coefficient = a.number_if_given(friction_coefficient_at)};
  if (a.given(grain_poisson_ratio_at))
    given.grain_poisson_ratio = a.number(grain_poisson_ratio_at);
  if (a.given(law_at)) {
    if (a.given(grain_shear_modulus_at) || a.given(grain_poisson_ratio_at) || a.given(materials_at))
      throw py::type_error("law contains the material of the grains: leave out grain_shear_modulus, "
                           "grain_poisson_ratio and materials");
    take_law(a, law_at, given);
  }
  if (a.given(materials_at))
    given.materials = studies::materials_of(packing, materials_by_type(a));
  if (a.given(stiffness_from_at))
    given.stiffness_from = a.choice(stiffness_from_at, sources_of_stiffness);
  given.rolling = turning_spring(a, rolling_stiffness_at);
  given.twisting = turning_spring(a, twisting_stiffness_at);
  return given;
}

py::object measure(const Arguments& a) {
  const auto packing = a.as<SharedPacking>(packing_at);
  const analysis::Given given = given_of(a, *packing);
  analysis::Wanted wanted = analysis::everything();
  wanted.network->stop_requested = stop_on_signal();
  wanted.network->prestress = a.flag(prestress_at);
  if (a.given(network_at) && !a.flag(network_at))
    wanted.network.reset();
  wanted.window = window_of(a, *packing);
  MeasuredFrame frame;
  {
    const Unlocked unlocked;
    if (packing->has(io::Finding::contacts_unknown))
      frame = studies::measure_frame(studies::with_overlap_contacts(*packing, given), given, wanted);
    else
      frame = studies::measure_frame(*packing, given, wanted);
  }
  throw_if_signalled();
  return py::cast(std::move(frame));
}

std::vector<Keyword> measure_keywords() {
  using estimate::Input;
  const std::string spring = "float, (float, str) or \"marshall\"";
  return {
      required("packing", "Packing",
               "From read() or packing(). Without contacts, overlapping spheres are assumed to touch."),
      optional(
          "law", "NormalLaw",
          "Contact law and material of the grains; for spheres the radii are those of the packing. Default:\n"
          "    derived from forces and overlaps."),
      optional("grain_shear_modulus", "float", ""),
      optional("grain_poisson_ratio", "float",
               "Material of spheres, instead of a law: G_g [Pa] and nu_g [1]."),
      optional("materials", "dict",
               "Materials of spheres of several types: {type: (shear modulus [Pa], Poisson's ratio [1])}."),
      of_input(Input::tangential_ratio, "float").or_none(),
      optional("friction_coefficient", "float",
               "Friction between grains [1]; without it estimated from the forces."),
      of_input(Input::grain_density, "float").or_none(),
      optional("stiffness_from", "{\"overlap\", \"force\", \"ratio\"}",
               "Source of k_n of the network; default: the overlaps, or the forces if the overlaps have few "
               "digits."),
      with_default("network", "True", "bool",
                   "Solve the contact network, rung 4: the part that takes the time."),
      with_default("prestress", "False", "bool", "Add the geometric stiffness of the contact forces."),
      with_default(
          "window", "'auto'", "\"auto\", None or three ranges, optional",
          "The part whose e, C_n, z*, fabric and stress are used for the closed forms: \"auto\", the\n"
          "    interior between walls or under a free surface, if there is one; None, the whole; or (low,\n"
          "    high) [m] along each axis, with None for a whole axis or an open end."),
      optional("rolling_stiffness", spring, ""),
      optional(
          "twisting_stiffness", spring,
          "For all contacts: a number times k_n R*^2 [1]; (k, \"displacement\"), k [N/m] times R*^2; (k,\n"
          "    \"angle\"), k [N m]; or \"marshall\", k_t R* d/2. Without it the values of the contacts.")};
}

void define_overlap_contacts(py::module_& module) {
  define(
      module, "overlap_contacts",
      {required("packing", "Packing", "Without contacts; a packing with contacts is returned unchanged."),
       optional("law", "NormalLaw",
                "Law of all contacts, for their normal forces; without it there are no forces.")},
      {"Adds the contacts of overlapping spheres to a packing of grains without contacts.",
       "Packing\n    Its notes list the assumptions. Tangential forces depend on the history and remain "
       "unknown.",
       "For a material refused by the law.", "", "analysis::Given", "analysis/measure.hpp"},
      [](const Arguments& a) {
        const auto packing = a.as<SharedPacking>(0);
        analysis::Given given;
        if (a.given(1))
          take_law(a, 1, given);
        return py::cast(unlocked(
            [&] { return std::make_shared<Packing>(studies::with_overlap_contacts(*packing, given)); }));
      },
      1);
}

} // namespace

void bind_measure(py::module_& module) {
  define(
      module,
      with_bulk_modulus(
          function(
              "measure", measure_keywords(),
              {"Measures a packing: contacts, fabric, stress, both 6 x 6 stiffnesses, every rung.\n\nOther "
               "threads can run meanwhile, and Ctrl-C ends it within a second.",
               "Measurement", "For an impossible packing or number.",
               "The linear response of the network is exact to 1e-10 of its largest entry; affine and "
               "relaxed parts as [AgnolinRoux2007c].",
               "analysis::measure", "analysis/measure.hpp"},
              &measure, 1),
          "grain_"));
  define_overlap_contacts(module);
}

} // namespace granum::python
