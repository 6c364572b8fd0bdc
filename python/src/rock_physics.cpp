// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>

#include <cstddef>

#include <granum/rock_physics/contact_cement.hpp>
#include <granum/rock_physics/coordination_relations.hpp>
#include <granum/rock_physics/digby.hpp>
#include <granum/rock_physics/hertz_mindlin.hpp>
#include <granum/rock_physics/jenkins.hpp>
#include <granum/rock_physics/sand_bounds.hpp>

#include "bindings.hpp"
#include "docstrings.hpp"
#include "keywords.hpp"
#include "material.hpp"
#include "moduli.hpp"

namespace granum::python {

namespace {

using rock_physics::SpherePacking;

/// Keywords that are all columns, followed by `strict`.
py::object moduli(const Arguments& a, std::span<const Argument> columns, std::size_t strict_at,
                  rock_physics::IsotropicEstimate (*model)(const double*)) {
  return py::cast(answer_rows(columns, a.flag(strict_at), ModuliRow{}, [&](const double* x, Notes& notes) {
    const rock_physics::IsotropicEstimate estimate = model(x);
    notes.add(estimate.validity);
    return ModuliRow{estimate.bulk_modulus, estimate.shear_modulus};
  }));
}

Argument optional(const Arguments& a, std::size_t at, const char* name, double otherwise) {
  return a.given(at) ? Argument{name, a[at]} : Argument{name, otherwise};
}

SpherePacking sphere_packing(const double* x) {
  return {.shear_modulus = x[0],
          .poisson_ratio = x[1],
          .porosity = x[2],
          .coordination_number = x[3],
          .pressure = x[4],
          .no_slip_fraction = x[5]};
}

const std::string sphere_parameters =
    std::string(equal_spheres_parameters) +
    "pressure : array_like\n    p >= 0, effective, compression positive [Pa].\n";

/// Parameters of both bounds: those of the packing at its critical porosity, and the porosity.
const std::string bound_parameters = [] {
  std::string text = sphere_parameters;
  const std::string own = "porosity : array_like\n    Pore volume by total volume, in [0, 1) [1].\n";
  return text.replace(
             text.find(own), own.size(),
             "critical_porosity : array_like\n    Porosity of the packing at the start of the bound, in [0, "
             "1) [1].\n") +
         no_slip_parameter + "porosity : array_like\n    In [0, critical_porosity] [1].\n";
}();

const std::string strict_and_result = std::string(strict_parameter) + R"(
Returns
-------
IsotropicModuli

Raises
------
InvalidArgument
    For impossible numbers; with arrays only under strict.
)";

/// \param    source   section Notes
std::string sphere_documentation(const char* what, const char* more, const std::string& source) {
  return std::string(what) + "\n" + sphere_parameters + more + strict_and_result + source;
}

const std::vector<Keyword> sphere_keywords{
    {"shear_modulus"}, {"poisson_ratio"},           {"porosity"},       {"coordination_number"},
    {"pressure"},      {"no_slip_fraction", "1.0"}, {"strict", "False"}};

std::array<Argument, 6> sphere_columns(const Arguments& a) {
  return {
      Argument{"shear_modulus", a[0]}, Argument{"poisson_ratio", a[1]},
      Argument{"porosity", a[2]},      Argument{"coordination_number", a[3]},
      Argument{"pressure", a[4]},      optional(a, 5, "no_slip_fraction", SpherePacking{}.no_slip_fraction)};
}

void bind_hertz_mindlin(py::module_& module) {
  define(module, with_bulk_modulus(
                     {"hertz_mindlin", sphere_keywords,
                      [](const Arguments& a) {
                        return moduli(a, sphere_columns(a), 6, [](const double* x) {
                          return rock_physics::hertz_mindlin(sphere_packing(x));
                        });
                      },
                      sphere_documentation(
                          "Random packing of equal spheres under uniform strain, with slip (Walton 1987).",
                          no_slip_parameter,
                          notes("[Walton1987] [Mavko2009]", "rock_physics::hertz_mindlin",
                                "rock_physics/hertz_mindlin.hpp"))}));
  define(module,
         with_bulk_modulus(
             {"jenkins_shear_modulus",
              {{"shear_modulus"},
               {"poisson_ratio"},
               {"porosity"},
               {"coordination_number"},
               {"pressure"},
               {"strict", "False"}},
              [](const Arguments& a) -> py::object {
                const Argument columns[] = {{"shear_modulus", a[0]}, {"poisson_ratio", a[1]},
                                            {"porosity", a[2]},      {"coordination_number", a[3]},
                                            {"pressure", a[4]},      {"no_slip_fraction", 0.0}};
                return moduli_of_shear(columns, a.flag(5), [](const double* x, Notes&) {
                  return rock_physics::jenkins_shear_modulus(sphere_packing(x));
                });
              },
              sphere_documentation("Shear modulus of frictionless spheres whose pairs may deviate from the "
                                   "mean strain (Jenkins 2005).\n\n"
                                   "The bulk modulus is NaN: the model has no formula for it.",
                                   "",
                                   notes("[Jenkins2005]", "rock_physics::jenkins_shear_modulus",
                                         "rock_physics/jenkins.hpp"))}));
}

void bind_bounds(py::module_& module) {
  static constexpr struct {
    const char* name;
    const char* what;
    const char* source;
    py::object (*call)(const Arguments&);
  } bounds[] = {
      {"soft_sand",
       "Lower bound between a packing at its critical porosity and the mineral (Dvorkin and Nur 1996).",
       "[DvorkinNur1996]",
       [](const Arguments& a) {
         const auto sphere = sphere_columns(a);
         const Argument columns[] = {sphere[0], sphere[1], {"critical_porosity", a[2]}, sphere[3],
                                     sphere[4], sphere[5], {"porosity", a[7]}};
         return moduli(a, columns, 6,
                       [](const double* x) { return rock_physics::soft_sand(sphere_packing(x), x[6]); });
       }},
      {"stiff_sand", "Upper bound between a packing at its critical porosity and the mineral (Gal 1998).",
       "[Gal1998]", [](const Arguments& a) {
         const auto sphere = sphere_columns(a);
         const Argument columns[] = {sphere[0], sphere[1], {"critical_porosity", a[2]}, sphere[3],
                                     sphere[4], sphere[5], {"porosity", a[7]}};
         return moduli(a, columns, 6,
                       [](const double* x) { return rock_physics::stiff_sand(sphere_packing(x), x[6]); });
       }}};
  std::vector<Keyword> keywords = sphere_keywords;
  keywords[2].name = "critical_porosity";
  keywords.push_back({"porosity"});
  for (const auto& bound : bounds)
    define(module, with_bulk_modulus({bound.name, keywords, bound.call,
                                      std::string(bound.what) + "\n" + bound_parameters + strict_and_result +
                                          notes(bound.source, std::string("rock_physics::") + bound.name,
                                                "rock_physics/sand_bounds.hpp")}));
}

void bind_digby(py::module_& module) {
  define(module,
         with_bulk_modulus(
             {"digby",
              {{"shear_modulus"},
               {"poisson_ratio"},
               {"porosity"},
               {"coordination_number"},
               {"pressure"},
               {"bond_radius_ratio"},
               {"strict", "False"}},
              [](const Arguments& a) {
                const Argument columns[] = {{"shear_modulus", a[0]}, {"poisson_ratio", a[1]},
                                            {"porosity", a[2]},      {"coordination_number", a[3]},
                                            {"pressure", a[4]},      {"bond_radius_ratio", a[5]}};
                return moduli(a, columns, 6, [](const double* x) {
                  return rock_physics::digby({.shear_modulus = x[0],
                                              .poisson_ratio = x[1],
                                              .porosity = x[2],
                                              .coordination_number = x[3],
                                              .pressure = x[4],
                                              .bond_radius_ratio = x[5]});
                });
              },
              sphere_documentation(
                  "Equal spheres bonded over small discs before the pressure is applied (Digby 1981).",
                  "bond_radius_ratio : array_like\n    Radius of the bonds by that of the grains, in "
                  "[0, 1) [1].\n",
                  notes("[Digby1981]", "rock_physics::digby", "rock_physics/digby.hpp"))}));
}

template <rock_physics::CementScheme scheme>
py::object cement(const Arguments& a) {
  const Argument columns[] = {
      {"shear_modulus", a[0]},        {"poisson_ratio", a[1]}, {"cement_shear_modulus", a[2]},
      {"cement_poisson_ratio", a[3]}, {"porosity", a[4]},      {"coordination_number", a[5]},
      {"cement_saturation", a[6]}};
  return moduli(a, columns, 7, [](const double* x) {
    return rock_physics::contact_cement({.shear_modulus = x[0],
                                         .poisson_ratio = x[1],
                                         .cement_shear_modulus = x[2],
                                         .cement_poisson_ratio = x[3],
                                         .porosity = x[4],
                                         .coordination_number = x[5],
                                         .cement_saturation = x[6]},
                                        scheme);
  });
}

void bind_cement(py::module_& module) {
  const std::vector<Keyword> keywords{{"shear_modulus"},        {"poisson_ratio"},  {"cement_shear_modulus"},
                                      {"cement_poisson_ratio"}, {"porosity"},       {"coordination_number"},
                                      {"cement_saturation"},    {"strict", "False"}};
  const std::string parameters = R"(
Parameters
----------
shear_modulus, poisson_ratio : array_like
    G_g > 0 [Pa] and nu_g [1] of the grain.
cement_shear_modulus, cement_poisson_ratio : array_like
    G_c > 0 [Pa] and nu_c [1] of the cement.
porosity : array_like
    Before cementation (critical), in [0, 1) [1].
coordination_number : array_like
    C_n = 2 N_c/N >= 0 [1].
cement_saturation : array_like
    Share of these pores filled with cement, in [0, 1] [1].
)";
  const std::string source = notes("[DvorkinNur1994] [DvorkinNur1996]", "rock_physics::contact_cement",
                                   "rock_physics/contact_cement.hpp");
  define(module, with_bulk_modulus(
                     with_bulk_modulus(
                         {"cement_at_contacts", keywords, cement<rock_physics::CementScheme::at_contacts>,
                          "Spheres with all cement in discs at their contacts (Dvorkin and Nur 1996).\n" +
                              parameters + strict_and_result + source}),
                     "cement_"));
  define(module, with_bulk_modulus(
                     with_bulk_modulus({"cement_in_surface_layer", keywords,
                                        cement<rock_physics::CementScheme::surface_layer>,
                                        "Spheres with an even layer of cement (Dvorkin and Nur 1996).\n" +
                                            parameters + strict_and_result + source}),
                     "cement_"));
}

void bind_coordination(py::module_& module) {
  using rock_physics::CoordinationRelation;
  static constexpr std::pair<const char*, CoordinationRelation> relations[] = {
      {"table", CoordinationRelation::murphy_table},
      {"quadratic", CoordinationRelation::murphy_quadratic},
      {"exponential", CoordinationRelation::murphy_exponential}};
  module.def(
      "murphy_coordination_number",
      [](const py::object& porosity, const std::string& relation) {
        for (const auto& [name, which] : relations)
          if (relation == name) {
            const Argument columns[] = {{"porosity", porosity}};
            return computed(answer_rows<double>(columns, true, 0.0,
                                                [which = which](const double* x, Notes&) {
                                                  return rock_physics::coordination_number(x[0], which);
                                                }),
                            [](double value) { return value; });
          }
        throw InvalidArgument("relation is one of table, quadratic, exponential, not " + relation);
      },
      py::kw_only(), py::arg("porosity"), py::arg("relation"),
      (R"(C_n of clean, well sorted grains from their porosity (Murphy 1982).

Parameters
----------
porosity : array_like
    Pore volume by total volume, in [0.2, 0.7] [1].
relation : {"table", "quadratic", "exponential"}
    The published relation to use. They differ by up to 0.7.

Returns
-------
float or ndarray
    C_n [1], of the shape of the porosity.
)" + raises_invalid("For the first porosity out of range, or another relation.") +
       notes("The relations do not depend on the preparation and do not replace a measured number. "
             "[Murphy1982] "
             "[Zimmer2007]",
             "rock_physics::coordination_number", "rock_physics/coordination_relations.hpp"))
          .c_str());
}

} // namespace

void bind_rock_physics(py::module_& module) {
  auto type =
      result_class<ModuliRow>(module, "IsotropicModuli", "Bulk and shear modulus of isotropic packings.");
  show_member<ModuliRow>(type, "bulk_modulus", offsetof(ModuliRow, bulk_modulus), "K [Pa].");
  show_member<ModuliRow>(type, "shear_modulus", offsetof(ModuliRow, shear_modulus), "G [Pa].");
  bind_hertz_mindlin(module);
  bind_bounds(module);
  bind_digby(module);
  bind_cement(module);
  bind_coordination(module);
}

} // namespace granum::python
