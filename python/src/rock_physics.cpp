// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>

#include <array>
#include <cstddef>

#include <granum/core/error.hpp>
#include <granum/rock_physics/cement.hpp>
#include <granum/rock_physics/sphere_packs.hpp>

#include "bindings.hpp"
#include "estimate.hpp"
#include "moduli.hpp"
#include "rows.hpp"

namespace granum::python {

namespace {

using rock_physics::CementScheme;
using rock_physics::IsotropicEstimate;
using rock_physics::SpherePacking;

using Model = IsotropicEstimate (*)(const double* numbers);

/// A model of the keywords that are columns, in their order.
KeywordFunction model(const char* name, std::vector<Keyword> keywords, Docstring text, Model of) {
  text.returns = "IsotropicModuli";
  text.refuses = refused_numbers;
  text.function = "rock_physics::" + text.function;
  text.header = "rock_physics/" + text.header;
  return with_bulk_modulus(function(name, std::move(keywords), std::move(text), [of](const Arguments& a) {
    return rows_of(a, ModuliRow{}, [of](const double* x, Notes& notes) {
      const IsotropicEstimate estimate = of(x);
      notes.add(estimate.validity);
      return ModuliRow{estimate.bulk_modulus, estimate.shear_modulus};
    });
  }));
}

/// The first six columns of most models.
SpherePacking sphere_packing(const double* x, double no_slip_fraction) {
  return {.shear_modulus = x[0],
          .poisson_ratio = x[1],
          .porosity = x[2],
          .coordination_number = x[3],
          .pressure = x[4],
          .no_slip_fraction = no_slip_fraction};
}

std::vector<Keyword> pressed_spheres(std::vector<Keyword> more) {
  return equal_spheres() +
         (std::vector{column("pressure", "p >= 0, effective, compression positive [Pa].")} + more);
}

/// Keywords of both bounds: those of the packing at its critical porosity, and the porosity.
std::vector<Keyword> bound_keywords() {
  std::vector<Keyword> out = pressed_spheres(
      {no_slip_keyword(), strict_keyword(), column("porosity", "In [0, critical_porosity] [1].")});
  out[2] = column("critical_porosity", "Porosity of the packing at the start of the bound, in [0, 1) [1].");
  return out;
}

void bind_spheres(py::module_& module) {
  define(module,
         model("hertz_mindlin", pressed_spheres({no_slip_keyword(), strict_keyword()}),
               {.summary = "Random packing of equal spheres under uniform strain, with slip (Walton 1987).",
                .remarks = "[Walton1987] [Mavko2009]",
                .function = "hertz_mindlin",
                .header = "sphere_packs.hpp"},
               [](const double* x) { return rock_physics::hertz_mindlin(sphere_packing(x, x[5])); }));
  define(
      module,
      model("jenkins_shear_modulus", pressed_spheres({strict_keyword()}),
            {.summary = "Shear modulus of frictionless spheres whose pairs may deviate from the mean strain "
                        "(Jenkins 2005).\n\nThe bulk modulus is NaN: the model has no formula for it.",
             .remarks = "[Jenkins2005]",
             .function = "jenkins_shear_modulus",
             .header = "sphere_packs.hpp"},
            [](const double* x) {
              return IsotropicEstimate{
                  ModuliRow{}.bulk_modulus, rock_physics::jenkins_shear_modulus(sphere_packing(x, 0)), {}};
            }));
  define(module,
         model("soft_sand", bound_keywords(),
               {.summary = "Lower bound between a packing at its critical porosity and the mineral (Dvorkin "
                           "and Nur 1996).",
                .remarks = "[DvorkinNur1996]",
                .function = "soft_sand",
                .header = "cement.hpp"},
               [](const double* x) { return rock_physics::soft_sand(sphere_packing(x, x[5]), x[6]); }));
  define(
      module,
      model("stiff_sand", bound_keywords(),
            {.summary = "Upper bound between a packing at its critical porosity and the mineral (Gal 1998).",
             .remarks = "[Gal1998]",
             .function = "stiff_sand",
             .header = "cement.hpp"},
            [](const double* x) { return rock_physics::stiff_sand(sphere_packing(x, x[5]), x[6]); }));
  define(
      module,
      model("digby",
            pressed_spheres(
                {column("bond_radius_ratio", "Radius of the bonds by that of the grains, in [0, 1) [1]."),
                 strict_keyword()}),
            {.summary = "Equal spheres bonded over small discs before the pressure is applied (Digby 1981).",
             .remarks = "[Digby1981]",
             .function = "digby",
             .header = "sphere_packs.hpp"},
            [](const double* x) {
              return rock_physics::digby({.shear_modulus = x[0],
                                          .poisson_ratio = x[1],
                                          .porosity = x[2],
                                          .coordination_number = x[3],
                                          .pressure = x[4],
                                          .bond_radius_ratio = x[5]});
            }));
}

template <CementScheme scheme>
IsotropicEstimate cement(const double* x) {
  return rock_physics::contact_cement({.shear_modulus = x[0],
                                       .poisson_ratio = x[1],
                                       .cement_shear_modulus = x[2],
                                       .cement_poisson_ratio = x[3],
                                       .porosity = x[4],
                                       .coordination_number = x[5],
                                       .cement_saturation = x[6]},
                                      scheme);
}

void bind_cement(py::module_& module) {
  std::vector<Keyword> keywords = equal_spheres();
  const std::vector<Keyword> solid = solid_keywords("cement_", "cement");
  keywords.insert(keywords.begin() + 2, solid.begin(), solid.end());
  keywords[4].says = "Before cementation (critical), in [0, 1) [1].";
  keywords.push_back(column("cement_saturation", "Share of these pores filled with cement, in [0, 1] [1]."));
  keywords.push_back(strict_keyword());
  const auto define_cement = [&](const char* name, const char* summary, Model of) {
    define(module, with_bulk_modulus(model(name, keywords,
                                           {.summary = summary,
                                            .remarks = "[DvorkinNur1994] [DvorkinNur1996]",
                                            .function = "contact_cement",
                                            .header = "cement.hpp"},
                                           of),
                                     "cement_"));
  };
  define_cement("cement_at_contacts",
                "Spheres with all cement in discs at their contacts (Dvorkin and Nur 1996).",
                cement<CementScheme::at_contacts>);
  define_cement("cement_in_surface_layer", "Spheres with an even layer of cement (Dvorkin and Nur 1996).",
                cement<CementScheme::surface_layer>);
}

void bind_coordination(py::module_& module) {
  using rock_physics::CoordinationRelation;
  static constexpr std::pair<const char*, CoordinationRelation> relations[] = {
      {"table", CoordinationRelation::murphy_table},
      {"quadratic", CoordinationRelation::murphy_quadratic},
      {"exponential", CoordinationRelation::murphy_exponential}};
  define(module, "murphy_coordination_number",
         {column("porosity", "Pore volume by total volume, in [0.2, 0.7] [1]."),
          required("relation", "{\"table\", \"quadratic\", \"exponential\"}",
                   "The published relation to use. They differ by up to 0.7.")},
         {"C_n of clean, well sorted grains from their porosity (Murphy 1982).",
          "float or ndarray\n    C_n [1], of the shape of the porosity.",
          "For the first porosity out of range, or another relation.",
          "The relations do not depend on the preparation and do not replace a measured number. [Murphy1982] "
          "[Zimmer2007]",
          "rock_physics::coordination_number", "rock_physics/sphere_packs.hpp"},
         [](const Arguments& a) {
           return numbers_of_rows(a, [relation = a.choice(1, relations)](const double* x) {
             return rock_physics::coordination_number(x[0], relation);
           });
         });
}

using rock_physics::StrainedPacking;
using rock_physics::UniaxialPacking;

UniaxialPacking walton_packing(const double* x) {
  return {.shear_modulus = x[0],
          .poisson_ratio = x[1],
          .porosity = x[2],
          .coordination_number = x[3],
          .uniaxial_strain = x[4],
          .no_slip_fraction = x[5]};
}

StrainedPacking strained_packing(const double* x) {
  return {.shear_modulus = x[0],
          .poisson_ratio = x[1],
          .porosity = x[2],
          .coordination_number = x[3],
          .hydrostatic_strain = x[4],
          .uniaxial_strain = x[5],
          .no_slip_fraction = x[6]};
}

template <class Model>
py::object stiffnesses(const Arguments& a, const Model& model) {
  return py::cast(Stiffnesses{
      answer_rows(columns_of(a), is_strict(a), StiffnessRow{}, [&](const double* x, Notes& notes) {
        const effective::Estimate estimate = model(x);
        notes.add(estimate.validity);
        return StiffnessRow{.stiffness = estimate.stiffness};
      })});
}

template <class Stress>
py::object stresses(const Arguments& a, const Stress& stress_at) {
  return rows_of(a, AxialStressRow{}, [&](const double* x, Notes&) {
    const stress::AxialStress stress = stress_at(x);
    return AxialStressRow{stress.v, stress.h};
  });
}

std::vector<Keyword> strained_spheres(std::vector<Keyword> hydrostatic_strain) {
  return equal_spheres() +
         (hydrostatic_strain +
          std::vector{column("uniaxial_strain", "e3 along axis 3, in [0, 1), compression positive [1]."),
                      no_slip_keyword(), strict_keyword()});
}

void bind_walton(py::module_& module) {
  const char *const remarks =
                        "The limit of norris_johnson without hydrostatic strain. An often reprinted C44 "
                        "differs from Walton's: it is not the average over the contacts. [Walton1987]",
                    *const header = "rock_physics/sphere_packs.hpp";
  define_of_solid(module, "walton_uniaxial", strained_spheres({}),
                  {"Stiffness of equal spheres after uniaxial compression (Walton 1987).", "Estimate",
                   refused_numbers, remarks, "rock_physics::walton_uniaxial", header},
                  [](const Arguments& a) {
                    return stiffnesses(
                        a, [](const double* x) { return rock_physics::walton_uniaxial(walton_packing(x)); });
                  });
  define_of_solid(module, "walton_uniaxial_stress", strained_spheres({}),
                  {"Stresses of a uniaxial compression (Walton 1987).", "AxialStress", refused_numbers,
                   remarks, "rock_physics::walton_uniaxial_stress", header},
                  [](const Arguments& a) {
                    return stresses(a, [](const double* x) {
                      return rock_physics::walton_uniaxial_stress(walton_packing(x));
                    });
                  });
}

void bind_norris_johnson(py::module_& module) {
  using rock_physics::StrainPath;
  static constexpr std::pair<const char*, StrainPath> paths[] = {
      {"hydrostatic_first", StrainPath::hydrostatic_first},
      {"uniaxial_first", StrainPath::uniaxial_first},
      {"simultaneous", StrainPath::simultaneous}};
  const char *const remarks = "Contacts follow the mean strain. The stresses depend on the order of the "
                              "strains, the stiffness does not. [NorrisJohnson1997] [Walton1987]",
                    *const header = "rock_physics/sphere_packs.hpp";
  const std::vector<Keyword> keywords = strained_spheres(
      {column("hydrostatic_strain", "e0 in all directions, in [0, 1), compression positive [1].")});
  define_of_solid(module, "norris_johnson", keywords,
                  {"Stiffness of equal spheres under a hydrostatic and a uniaxial strain.", "Estimate",
                   refused_numbers, remarks, "rock_physics::norris_johnson", header},
                  [](const Arguments& a) {
                    return stiffnesses(
                        a, [](const double* x) { return rock_physics::norris_johnson(strained_packing(x)); });
                  });
  const std::size_t path_at = keywords.size();
  define_of_solid(
      module, "norris_johnson_stress",
      keywords + std::vector{required("path", "{\"hydrostatic_first\", \"uniaxial_first\", \"simultaneous\"}",
                                      "Order of the two strains.")},
      {"Stresses of a packing at these strains, depending on their order.", "AxialStress", refused_numbers,
       remarks, "rock_physics::norris_johnson_stress", header},
      [path_at](const Arguments& a) {
        return stresses(a, [path = a.choice(path_at, paths)](const double* x) {
          return rock_physics::norris_johnson_stress(strained_packing(x), path);
        });
      });
}

} // namespace

std::vector<Keyword> equal_spheres() {
  return solid_keywords("", "grain") +
         std::vector{column("porosity", "Pore volume by total volume, in [0, 1) [1]."),
                     column("coordination_number", "C_n = 2 N_c/N >= 0 [1].")};
}

Keyword no_slip_keyword() {
  return column("no_slip_fraction",
                "Share of contacts without slip, in [0, 1] [1]: 1 rough, 0 smooth grains.")
      .or_number(SpherePacking{}.no_slip_fraction);
}

void bind_rock_physics(py::module_& module) {
  result_class<ModuliRow>(module, "IsotropicModuli", "Bulk and shear modulus of isotropic packings.")
      .show("bulk_modulus", "K [Pa].", &ModuliRow::bulk_modulus)
      .show("shear_modulus", "G [Pa].", &ModuliRow::shear_modulus);
  bind_spheres(module);
  bind_cement(module);
  bind_coordination(module);
  result_class<AxialStressRow>(module, "AxialStress",
                               "A vertical and two equal horizontal stresses, compression positive.")
      .show("stress_v", "sigma_v [Pa].", &AxialStressRow::v)
      .show("stress_h", "sigma_h [Pa].", &AxialStressRow::h);
  bind_walton(module);
  bind_norris_johnson(module);
}

} // namespace granum::python
