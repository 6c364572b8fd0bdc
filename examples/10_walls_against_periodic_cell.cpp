// SPDX-License-Identifier: GPL-3.0-or-later
//
// Example 10: what is the effect of rigid walls on a specimen, and on its measured void ratio and contacts?
//
// 500 spheres in a periodic cell and 500 between six smooth walls, both dense, under 100 kPa. Along walls
// grains lie in layers and have fewer contacts. So the specimen between walls has a larger void ratio e and a
// smaller coordination number C_n (contacts per grain) than the periodic one. C_n of the grains two diameters
// and more from the walls is near C_n of the periodic cell. Takes seconds.
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>

#include <granum/analysis/measure.hpp>
#include <granum/contact/grains.hpp>
#include <granum/triaxial/specimen.hpp>

using namespace granum;

namespace {

/// A dense specimen at 100 kPa; empty if the compression did not converge.
std::optional<dem::Specimen> specimen(const triaxial::SpecimenRecipe& recipe) {
  dem::Specimen state = triaxial::start_of_compression(triaxial::frictionless_specimen(recipe).state,
                                                       triaxial::Density::dense, recipe);
  if (!triaxial::isotropic_path(state, recipe.material, {30e3, 100e3}, triaxial::compression_options(),
                                [&](const triaxial::Snapshot& snapshot) {
                                  state = snapshot.state;
                                  return snapshot.report.converged();
                                }))
    return std::nullopt;
  return state;
}

} // namespace

int main() {
  // 1. One recipe, with and without walls.
  const contact::GrainMaterial grain{.shear_modulus = 30e9, .poisson_ratio = 0.15};
  const double radius = 0.5e-3;
  triaxial::SpecimenRecipe recipe{
      .material = {.law = contact::PowerLaw::sphere(grain, radius),
                   .tangential_ratio = contact::mindlin_stiffness_ratio(grain.poisson_ratio),
                   .friction_coefficient =
                       contact::Friction::from_angle(26.5 * std::numbers::pi / 180).coefficient()},
      .radius = radius,
      .grains = 500};
  const std::optional<dem::Specimen> periodic = specimen(recipe);
  recipe.wall_friction = 0; // smooth
  const std::optional<dem::Specimen> walled = specimen(recipe);
  if (!periodic || !walled)
    return 1;

  // 2. Both specimens, and the interior of the walled one: all grains at least two diameters from the walls.
  const analysis::Given given{.law = recipe.material.law,
                              .tangential_ratio = recipe.material.tangential_ratio};
  const double in_cell =
      analysis::measure(dem::contact_network(*periodic, recipe.material), given).counts.coordination_number;
  const analysis::Measurement box = analysis::measure(dem::contact_network(*walled, recipe.material), given,
                                                      {.interior_layer = 4 * radius});
  const double in_box = box.counts.coordination_number;
  const analysis::InteriorMeasures& inside = box.interior.value();
  std::printf("                     C_n      e\n");
  std::printf("periodic cell       %5.2f   %.3f\n", in_cell, dem::void_ratio(*periodic));
  std::printf("six walls, all      %5.2f   %.3f\n", in_box, dem::void_ratio(*walled));
  std::printf("six walls, inside   %5.2f           %zu of %zu grains\n", inside.micro.coordination_number,
              inside.grains, walled->grain_count());

  // 3. Check: with walls C_n is smaller by more than 0.3 and e larger by more than 0.02; C_n of the interior
  //    differs from C_n of the periodic cell by less than 0.5, the scatter of so few grains.
  const bool cost = in_box < in_cell - 0.3 && dem::void_ratio(*walled) > dem::void_ratio(*periodic) + 0.02;
  const bool same_inside = std::abs(inside.micro.coordination_number - in_cell) < 0.5;
  return cost && same_inside ? 0 : 1;
}
