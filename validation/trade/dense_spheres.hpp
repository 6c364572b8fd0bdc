// SPDX-License-Identifier: GPL-3.0-or-later
// Dense spheres of Table 1 of the paper at 100 kPa, and friction angles of what is sheared from there.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <granum/contact/grains.hpp>
#include <granum/core/error.hpp>
#include <granum/stress/stress.hpp>
#include <granum/triaxial/specimen.hpp>

#include "../relaxation/specimens.hpp"

namespace trade {

using namespace granum;
using relaxation::kPa;

inline constexpr double pressure = 100 * kPa, degree = M_PI / 180;

inline triaxial::SpecimenRecipe recipe_of(bool walls, std::uint64_t seed, std::size_t grains) {
  triaxial::SpecimenRecipe recipe{
      .material = {.law = contact::PowerLaw::sphere(relaxation::grain, 0.5e-3),
                   .tangential_ratio = contact::mindlin_stiffness_ratio(relaxation::grain.poisson_ratio),
                   .friction_coefficient = contact::Friction::from_angle(26.5 * degree).coefficient()},
      .radius = 0.5e-3,
      .grains = grains,
      .seed = seed};
  if (walls)
    recipe.wall_friction = 0;
  return recipe;
}

/// The specimen under isotropic pressure.
inline dem::Specimen compressed(const triaxial::SpecimenRecipe& recipe) {
  dem::Specimen state = triaxial::start_of_compression(triaxial::frictionless_specimen(recipe).state,
                                                       triaxial::Density::dense, recipe);
  const auto keep = [&](const triaxial::Snapshot& snapshot) {
    state = snapshot.state;
    return snapshot.report.converged();
  };
  if (!triaxial::isotropic_path(state, recipe.material, {10 * kPa, 30 * kPa, pressure},
                                triaxial::compression_options(), keep))
    throw Error("a specimen did not come to rest");
  return state;
}

/// Mobilised friction angle of q/p' on a path [deg].
inline double angle_at(stress::ShearPath path, double eta) {
  return stress::mobilised_friction_angle(stress::stress_on_path(path, pressure, eta)) / degree;
}

/// With its standard error.
struct Mean {
  double value = 0, error = 0;
};

inline Mean mean_of(const std::vector<double>& values) {
  const double count = static_cast<double>(values.size());
  double sum = 0, squares = 0;
  for (const double value : values) {
    sum += value;
    squares += value * value;
  }
  const double mean = sum / count;
  return {mean, count > 1 ? std::sqrt(std::max(0.0, squares / count - mean * mean) / (count - 1)) : 0};
}

} // namespace trade
