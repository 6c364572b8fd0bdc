// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>

#include <array>
#include <cstddef>

#include <granum/core/error.hpp>
#include <granum/rock_physics/norris_johnson.hpp>
#include <granum/rock_physics/walton_uniaxial.hpp>

#include "bindings.hpp"
#include "estimate.hpp"
#include "moduli.hpp"

namespace granum::python {

namespace {

using rock_physics::StrainedPacking;
using rock_physics::UniaxialPacking;

/// Columns common to both models come first.
enum : std::size_t { shear_modulus_at, poisson_ratio_at, porosity_at, coordination_number_at, strains_at };

UniaxialPacking walton_packing(const double* x) {
  return {.shear_modulus = x[shear_modulus_at],
          .poisson_ratio = x[poisson_ratio_at],
          .porosity = x[porosity_at],
          .coordination_number = x[coordination_number_at],
          .uniaxial_strain = x[strains_at],
          .no_slip_fraction = x[strains_at + 1]};
}

StrainedPacking strained_packing(const double* x) {
  return {.shear_modulus = x[shear_modulus_at],
          .poisson_ratio = x[poisson_ratio_at],
          .porosity = x[porosity_at],
          .coordination_number = x[coordination_number_at],
          .hydrostatic_strain = x[strains_at],
          .uniaxial_strain = x[strains_at + 1],
          .no_slip_fraction = x[strains_at + 2]};
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
                    *const header = "rock_physics/walton_uniaxial.hpp";
  define(module, with_bulk_modulus(
                     function("walton_uniaxial", strained_spheres({}),
                              {"Stiffness of equal spheres after uniaxial compression (Walton 1987).",
                               "Estimate", refused_numbers, remarks, "rock_physics::walton_uniaxial", header},
                              [](const Arguments& a) {
                                return stiffnesses(a, [](const double* x) {
                                  return rock_physics::walton_uniaxial(walton_packing(x));
                                });
                              })));
  define(module, with_bulk_modulus(
                     function("walton_uniaxial_stress", strained_spheres({}),
                              {"Stresses of a uniaxial compression (Walton 1987).", "AxialStress",
                               refused_numbers, remarks, "rock_physics::walton_uniaxial_stress", header},
                              [](const Arguments& a) {
                                return stresses(a, [](const double* x) {
                                  return rock_physics::walton_uniaxial_stress(walton_packing(x));
                                });
                              })));
}

void bind_norris_johnson(py::module_& module) {
  using rock_physics::StrainPath;
  static constexpr std::pair<const char*, StrainPath> paths[] = {
      {"hydrostatic_first", StrainPath::hydrostatic_first},
      {"uniaxial_first", StrainPath::uniaxial_first},
      {"simultaneous", StrainPath::simultaneous}};
  const char *const remarks = "Contacts follow the mean strain. The stresses depend on the order of the "
                              "strains, the stiffness does not. [NorrisJohnson1997] [Walton1987]",
                    *const header = "rock_physics/norris_johnson.hpp";
  const std::vector<Keyword> keywords = strained_spheres(
      {column("hydrostatic_strain", "e0 in all directions, in [0, 1), compression positive [1].")});
  define(module, with_bulk_modulus(
                     function("norris_johnson", keywords,
                              {"Stiffness of equal spheres under a hydrostatic and a uniaxial strain.",
                               "Estimate", refused_numbers, remarks, "rock_physics::norris_johnson", header},
                              [](const Arguments& a) {
                                return stiffnesses(a, [](const double* x) {
                                  return rock_physics::norris_johnson(strained_packing(x));
                                });
                              })));
  const std::size_t path_at = keywords.size();
  define(module, with_bulk_modulus(function(
                     "norris_johnson_stress",
                     keywords + std::vector{required(
                                    "path", "{\"hydrostatic_first\", \"uniaxial_first\", \"simultaneous\"}",
                                    "Order of the two strains.")},
                     {"Stresses of a packing at these strains, depending on their order.", "AxialStress",
                      refused_numbers, remarks, "rock_physics::norris_johnson_stress", header},
                     [path_at](const Arguments& a) {
                       return stresses(a, [path = a.choice(path_at, paths)](const double* x) {
                         return rock_physics::norris_johnson_stress(strained_packing(x), path);
                       });
                     })));
}

} // namespace

void bind_uniaxial(py::module_& module) {
  result_class<AxialStressRow>(module, "AxialStress",
                               "A vertical and two equal horizontal stresses, compression positive.")
      .show("stress_v", "sigma_v [Pa].", &AxialStressRow::v)
      .show("stress_h", "sigma_h [Pa].", &AxialStressRow::h);
  bind_walton(module);
  bind_norris_johnson(module);
}

} // namespace granum::python
