// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>

#include <array>
#include <cstddef>
#include <limits>

#include <granum/core/error.hpp>
#include <granum/rock_physics/norris_johnson.hpp>
#include <granum/rock_physics/walton_uniaxial.hpp>

#include "bindings.hpp"
#include "docstrings.hpp"
#include "estimate.hpp"
#include "material.hpp"
#include "moduli.hpp"

namespace granum::python {

namespace {

using rock_physics::StrainedPacking;
using rock_physics::UniaxialPacking;

/// Keywords common to both models come first; `strict` is the last.
enum : std::size_t { shear_modulus_at, poisson_ratio_at, porosity_at, coordination_number_at, strains_at };

const std::vector<Keyword> walton_keywords{
    {"shear_modulus"},   {"poisson_ratio"},           {"porosity"},       {"coordination_number"},
    {"uniaxial_strain"}, {"no_slip_fraction", "1.0"}, {"strict", "False"}};
const std::vector<Keyword> norris_johnson_keywords{
    {"shear_modulus"},           {"poisson_ratio"},      {"porosity"},
    {"coordination_number"},     {"hydrostatic_strain"}, {"uniaxial_strain"},
    {"no_slip_fraction", "1.0"}, {"strict", "False"}};

/// All keywords but strict, in their order; the share of contacts without slip is 1 where it is left out.
std::vector<Argument> columns(const Arguments& a, const std::vector<Keyword>& keywords) {
  std::vector<Argument> out;
  for (std::size_t k = 0; k + 1 < keywords.size(); ++k)
    if (a.given(k))
      out.push_back({keywords[k].name, a[k]});
    else
      out.push_back({keywords[k].name, UniaxialPacking{}.no_slip_fraction});
  return out;
}

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
py::object stiffnesses(const Arguments& a, const std::vector<Keyword>& keywords, const Model& model) {
  const auto given = columns(a, keywords);
  return py::cast(Stiffnesses{
      answer_rows(given, a.flag(keywords.size() - 1), StiffnessRow{}, [&](const double* x, Notes& notes) {
        const effective::Estimate estimate = model(x);
        notes.add(estimate.validity);
        return StiffnessRow{.stiffness = estimate.stiffness};
      })});
}

template <class Model>
py::object stresses(const Arguments& a, const std::vector<Keyword>& keywords, const Model& model) {
  const auto given = columns(a, keywords);
  return py::cast(
      answer_rows(given, a.flag(keywords.size() - 1), AxialStressRow{}, [&](const double* x, Notes&) {
        const stress::AxialStress stress = model(x);
        return AxialStressRow{stress.v, stress.h};
      }));
}

rock_physics::StrainPath path_of(const std::string& name) {
  using rock_physics::StrainPath;
  static constexpr std::pair<const char*, StrainPath> paths[] = {
      {"hydrostatic_first", StrainPath::hydrostatic_first},
      {"uniaxial_first", StrainPath::uniaxial_first},
      {"simultaneous", StrainPath::simultaneous}};
  for (const auto& [known, path] : paths)
    if (name == known)
      return path;
  throw InvalidArgument("path is one of hydrostatic_first, uniaxial_first, simultaneous, not " + name);
}

/// \param    hydrostatic   text on the strain e0, if the model has one
/// \param    result        the class
std::string documentation(const std::string& what, const std::string& hydrostatic, const std::string& more,
                          const std::string& result, const std::string& source) {
  return what + "\n" + equal_spheres_parameters + hydrostatic +
         "uniaxial_strain : array_like\n    e3 along axis 3, in [0, 1), compression positive [1].\n" +
         no_slip_parameter + strict_parameter + more +
         R"(
Returns
-------
)" + result +
         R"(

Raises
------
InvalidArgument
    For impossible numbers; with arrays only under strict.
)" + source;
}

void bind_walton(py::module_& module) {
  const auto source = [](const char* function) {
    return notes("The limit of norris_johnson without hydrostatic strain. An often reprinted C44 differs "
                 "from Walton's: it is not the average over the contacts. [Walton1987]",
                 std::string("rock_physics::") + function, "rock_physics/walton_uniaxial.hpp");
  };
  define(module, with_bulk_modulus(
                     {"walton_uniaxial", walton_keywords,
                      [](const Arguments& a) {
                        return stiffnesses(a, walton_keywords, [](const double* x) {
                          return rock_physics::walton_uniaxial(walton_packing(x));
                        });
                      },
                      documentation("Stiffness of equal spheres after uniaxial compression (Walton 1987).",
                                    "", "", "Estimate", source("walton_uniaxial"))}));
  define(module, with_bulk_modulus({"walton_uniaxial_stress", walton_keywords,
                                    [](const Arguments& a) {
                                      return stresses(a, walton_keywords, [](const double* x) {
                                        return rock_physics::walton_uniaxial_stress(walton_packing(x));
                                      });
                                    },
                                    documentation("Stresses of a uniaxial compression (Walton 1987).", "", "",
                                                  "AxialStress", source("walton_uniaxial_stress"))}));
}

void bind_norris_johnson(py::module_& module) {
  const std::string hydrostatic = "hydrostatic_strain : array_like\n    e0 in all directions, in [0, 1), "
                                  "compression positive [1].\n";
  const auto source = [](const char* function) {
    return notes(
        "Contacts follow the mean strain. The stresses depend on the order of the strains, the stiffness "
        "does not. [NorrisJohnson1997] [Walton1987]",
        std::string("rock_physics::") + function, "rock_physics/norris_johnson.hpp");
  };
  define(module, with_bulk_modulus(
                     {"norris_johnson", norris_johnson_keywords,
                      [](const Arguments& a) {
                        return stiffnesses(a, norris_johnson_keywords, [](const double* x) {
                          return rock_physics::norris_johnson(strained_packing(x));
                        });
                      },
                      documentation("Stiffness of equal spheres under a hydrostatic and a uniaxial strain.",
                                    hydrostatic, "", "Estimate", source("norris_johnson"))}));
  std::vector<Keyword> with_path = norris_johnson_keywords;
  with_path.push_back({"path"});
  define(module,
         with_bulk_modulus(
             {"norris_johnson_stress", with_path,
              [](const Arguments& a) {
                const auto path = path_of(a.text(norris_johnson_keywords.size()));
                return stresses(a, norris_johnson_keywords, [path](const double* x) {
                  return rock_physics::norris_johnson_stress(strained_packing(x), path);
                });
              },
              documentation("Stresses of a packing at these strains, depending on their order.", hydrostatic,
                            "path : {\"hydrostatic_first\", \"uniaxial_first\", \"simultaneous\"}\n"
                            "    Order of the two strains.\n",
                            "AxialStress", source("norris_johnson_stress"))}));
}

} // namespace

void bind_uniaxial(py::module_& module) {
  auto type = result_class<AxialStressRow>(
      module, "AxialStress", "A vertical and two equal horizontal stresses, compression positive.");
  show_member<AxialStressRow>(type, "stress_v", offsetof(AxialStressRow, v), "sigma_v [Pa].");
  show_member<AxialStressRow>(type, "stress_h", offsetof(AxialStressRow, h), "sigma_h [Pa].");
  bind_walton(module);
  bind_norris_johnson(module);
}

} // namespace granum::python
