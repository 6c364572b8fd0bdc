// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <tuple>

#include <granum/analysis/measure.hpp>
#include <granum/core/error.hpp>

#include "bindings.hpp"
#include "docstrings.hpp"
#include "errors.hpp"
#include "keywords.hpp"
#include "material.hpp"
#include "packing.hpp"
#include "rows.hpp"
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

/// The law of two grains for a law between two grains of any material and radius.
analysis::LawFamily family_of(const contact::NormalLaw& law) {
  return [law](const contact::GrainMaterial& grain, double radius) { return law.of(grain, radius); };
}

std::optional<double> number_if_given(const Arguments& a, std::size_t at, const char* name) {
  return a.given(at) ? std::optional(number_of(name, a[at])) : std::nullopt;
}

packing::StiffnessFrom stiffness_from(const std::string& name) {
  using packing::StiffnessFrom;
  static constexpr std::pair<const char*, StiffnessFrom> all[] = {
      {"overlap", StiffnessFrom::overlap}, {"force", StiffnessFrom::force}, {"ratio", StiffnessFrom::ratio}};
  for (const auto& [known, from] : all)
    if (name == known)
      return from;
  throw InvalidArgument("stiffness_from is one of overlap, force, ratio, not " + name);
}

/// A number, or a pair of a number and its kind.
std::optional<packing::TurningSpring> turning_spring(const Arguments& a, std::size_t at, const char* name) {
  using Of = packing::TurningSpring::Of;
  if (!a.given(at))
    return std::nullopt;
  if (!py::isinstance<py::str>(a[at]) && !py::isinstance<py::tuple>(a[at]))
    return packing::TurningSpring{.value = number_of(name, a[at]), .of = Of::normal};
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
  throw InvalidArgument(std::string(name) +
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

analysis::Given given_of(const Arguments& a, const Packing& packing) {
  analysis::Given given{
      .grain_shear_modulus = number_if_given(a, grain_shear_modulus_at, "grain_shear_modulus"),
      .grain_density = number_if_given(a, grain_density_at, "grain_density"),
      .law_assumed = !a.given(law_at),
      .tangential_ratio = number_if_given(a, tangential_ratio_at, "tangential_ratio"),
      .friction_coefficient = number_if_given(a, friction_coefficient_at, "friction_coefficient")};
  if (const auto ratio = number_if_given(a, grain_poisson_ratio_at, "grain_poisson_ratio"))
    given.grain_poisson_ratio = *ratio;
  if (a.given(law_at)) {
    if (a.given(grain_shear_modulus_at) || a.given(grain_poisson_ratio_at) || a.given(materials_at))
      throw py::type_error("law contains the material of the grains: leave out grain_shear_modulus, "
                           "grain_poisson_ratio and materials");
    const auto& law = a.as<const contact::NormalLaw&>(law_at, "a contact law");
    given.law_family = family_of(law);
    given.grain_shear_modulus = law.grain().shear_modulus;
    given.grain_poisson_ratio = law.grain().poisson_ratio;
  }
  if (a.given(materials_at))
    given.materials = studies::materials_of(packing, materials_by_type(a));
  if (a.given(stiffness_from_at))
    given.stiffness_from = stiffness_from(a.text(stiffness_from_at));
  given.rolling = turning_spring(a, rolling_stiffness_at, "rolling_stiffness");
  given.twisting = turning_spring(a, twisting_stiffness_at, "twisting_stiffness");
  return given;
}

py::object measure(const Arguments& a) {
  const SharedPacking packing = a.as<SharedPacking>(packing_at, "a Packing");
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

void define_overlap_contacts(py::module_& module) {
  define(module,
         {"overlap_contacts",
          {{"packing"}, {"law", "None"}},
          [](const Arguments& a) -> py::object {
            const SharedPacking packing = a.as<SharedPacking>(0, "a Packing");
            analysis::Given given;
            if (a.given(1)) {
              const auto& law = a.as<const contact::NormalLaw&>(1, "a contact law");
              given.law_family = family_of(law);
              given.grain_shear_modulus = law.grain().shear_modulus;
              given.grain_poisson_ratio = law.grain().poisson_ratio;
            }
            SharedPacking out;
            {
              const Unlocked unlocked;
              out = std::make_shared<Packing>(studies::with_overlap_contacts(*packing, given));
            }
            return py::cast(out);
          },
          std::string(R"(Adds the contacts of overlapping spheres to a packing of grains without contacts.

Parameters
----------
packing : Packing
    Without contacts; a packing with contacts is returned unchanged.
law : NormalLaw, optional
    Law of all contacts, for their normal forces; without it there are no forces.

Returns
-------
Packing
    Its notes list the assumptions. Tangential forces depend on the history and remain unknown.
)") + raises_invalid("For a material refused by the law.") +
              notes("", "analysis::Given", "analysis/measure.hpp"),
          1});
}

} // namespace

void bind_measure(py::module_& module) {
  define(module,
         with_bulk_modulus(
             {"measure",
              {{"packing"},
               {"law", "None"},
               {"grain_shear_modulus", "None"},
               {"grain_poisson_ratio", "None"},
               {"materials", "None"},
               {"tangential_ratio", "None"},
               {"friction_coefficient", "None"},
               {"grain_density", "None"},
               {"stiffness_from", "None"},
               {"network", "True"},
               {"prestress", "False"},
               {"window", "'auto'"},
               {"rolling_stiffness", "None"},
               {"twisting_stiffness", "None"}},
              &measure,
              std::string() +
                  R"(Measures a packing: contacts, fabric, stress, both 6 x 6 stiffnesses, every rung.

Other threads can run meanwhile, and Ctrl-C ends it within a second.

Parameters
----------
packing : Packing
    From read() or packing(). Without contacts, overlapping spheres are assumed to touch.
law : NormalLaw, optional
    Contact law and material of the grains; for spheres the radii are those of the packing. Default: derived
    from forces and overlaps.
grain_shear_modulus, grain_poisson_ratio : float, optional
    Material of spheres, instead of a law: G_g [Pa] and nu_g [1].
materials : dict, optional
    Materials of spheres of several types: {type: (shear modulus [Pa], Poisson's ratio [1])}.
tangential_ratio : float, optional
    k_t/k_n [1]; without it that of the no-slip contact.
friction_coefficient : float, optional
    Friction between grains [1]; without it estimated from the forces.
grain_density : float, optional
    Of the grains' solid [kg/m3].
stiffness_from : {"overlap", "force", "ratio"}, optional
    Source of k_n of the network; default: the overlaps, or the forces if the overlaps have few digits.
network : bool
    Solve the contact network, rung 4: the part that takes the time.
prestress : bool
    Add the geometric stiffness of the contact forces.
window : "auto", None or three ranges, optional
    The part whose e, C_n, z*, fabric and stress are used for the closed forms: "auto", the interior between
    walls or under a free surface, if there is one; None, the whole; or (low, high) [m] along each axis, with
    None for a whole axis or an open end.
rolling_stiffness, twisting_stiffness : float, (float, str) or "marshall", optional
    For all contacts: a number times k_n R*^2 [1]; (k, "displacement"), k [N/m] times R*^2; (k, "angle"), k
    [N m]; or "marshall", k_t R* d/2. Without it the values of the contacts.

Returns
-------
Measurement

Raises
------
InvalidArgument
    For an impossible packing or number.
)" +
                  notes("The linear response of the network is exact to 1e-10 of its largest entry; affine "
                        "and relaxed parts as "
                        "[AgnolinRoux2007c].",
                        "analysis::measure", "analysis/measure.hpp"),
              1},
             "grain_"));
  define_overlap_contacts(module);
}

} // namespace granum::python
