// SPDX-License-Identifier: GPL-3.0-or-later
// A small specimen of granum's own, at rest, as if another code had made it.
#pragma once

#include <vector>

#include <granum/triaxial/probe.hpp>
#include <granum/triaxial/specimen.hpp>

namespace granum::samples {

inline const contact::GrainMaterial specimen_grain{30e9, 0.15};
inline constexpr double specimen_radius = 0.5e-3;
inline constexpr double specimen_friction = 0.5;

/// Dense spheres with friction.
inline triaxial::SpecimenRecipe specimen_recipe(double first_pressure, std::size_t grains = 80) {
  return {.material = {.law = contact::PowerLaw::sphere(specimen_grain, specimen_radius),
                       .tangential_ratio = contact::mindlin_stiffness_ratio(specimen_grain.poisson_ratio),
                       .friction_coefficient = specimen_friction},
          .radius = specimen_radius,
          .grains = grains,
          .seed = 3,
          .first_pressure = first_pressure};
}

/// Such a specimen at each of the pressures, as the engine holds it.
inline std::vector<dem::Specimen> states_at(const std::vector<double>& pressures,
                                            const triaxial::SpecimenRecipe& recipe) {
  const dem::Specimen start = triaxial::start_of_compression(triaxial::frictionless_specimen(recipe).state,
                                                             triaxial::Density::dense, recipe);
  std::vector<dem::Specimen> states;
  triaxial::isotropic_path(start, recipe.material, pressures, triaxial::compression_options(),
                           [&](const triaxial::Snapshot& snapshot) {
                             states.push_back(
                                 triaxial::freeze_in_place(snapshot.state, recipe.material).state());
                             return true;
                           });
  return states;
}

inline std::vector<packing::Assembly> specimen_at(const std::vector<double>& pressures,
                                                  std::size_t grains = 80) {
  const triaxial::SpecimenRecipe recipe = specimen_recipe(pressures.front(), grains);
  std::vector<packing::Assembly> frozen;
  for (const dem::Specimen& state : states_at(pressures, recipe))
    frozen.push_back(dem::contact_network(state, recipe.material));
  return frozen;
}

/// One such state, made once.
inline const packing::Assembly& specimen() {
  static const packing::Assembly state = specimen_at({50e3}).front();
  return state;
}

} // namespace granum::samples
