// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/triaxial/probe.hpp>

#include <granum/dem/neighbours.hpp>
#include <granum/sizes/distribution.hpp>

#include "dem/lattice_state.hpp"
#include "unit.hpp"

using namespace granum::triaxial;

namespace {

SpecimenRecipe recipe_of(std::size_t grains) {
  SpecimenRecipe recipe{.material = {.law = test::quartz_sphere(0.5e-3)}, .radius = 0.5e-3};
  recipe.grains = grains;
  return recipe;
}

} // namespace

TEST_CASE("scattered grains: the seed decides, to the bit") {
  SpecimenRecipe recipe = recipe_of(100);
  const dem::Specimen first = scattered_specimen(recipe);
  CHECK(first == scattered_specimen(recipe));
  recipe.seed = 2;
  CHECK_FALSE(first == scattered_specimen(recipe));
}

TEST_CASE("scattered grains: solid fractions that no search ends at are refused") {
  for (const double fraction : {0.0, -0.1, 0.31, 0.5})
    CHECK_THROWS_AS((void)scattered_specimen(recipe_of(100), fraction), InvalidArgument);
  CHECK_THROWS_AS((void)scattered_specimen(recipe_of(10)), InvalidArgument);
}

TEST_CASE("scattered grains, equal or not, are all there, in the cell, and touch none") {
  for (const char* sizes : {"equal", "lognormal:0.35"})
    for (const double fraction : {0.02, 0.25, 0.3}) {
      SpecimenRecipe recipe = recipe_of(600);
      recipe.sizes = sizes::parse_distribution(sizes);
      const dem::Specimen state = scattered_specimen(recipe, fraction);
      CHECK(state.grain_count() == 600);
      CHECK(1 / (1 + dem::void_ratio(state)) == relative(fraction, 1e-12));
      std::vector<double> radius;
      for (std::size_t g = 0; g < state.grain_count(); ++g)
        radius.push_back(state.radius_of(g));
      CHECK(dem::neighbour_pairs(state.cell, state.position, radius, 0).empty());
      // Not by chance: the same places with larger grains do touch.
      CHECK_FALSE(dem::neighbour_pairs(state.cell, state.position, radius, recipe.radius).empty());
      for (const Vec3& x : state.position)
        for (int axis = 0; axis < 3; ++axis)
          CHECK((x[axis] >= 0 && x[axis] <= state.cell(axis, axis)));
    }
}
