// SPDX-License-Identifier: GPL-3.0-or-later
#include "densest_packing.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include <granum/core/error.hpp>
#include <granum/triaxial/specimen.hpp>

namespace granum::cli {

namespace {

using estimate::InputValues;

/// The mean void ratio of packings of these grains that are compressed without friction.
double made_void_ratio(const InputValues& values) {
  if (known_shape(values) != estimate::GrainShape::sphere)
    throw InvalidArgument("--densest made is for beads: add --grain-shape sphere");
  constexpr std::size_t fewest = 1000;
  constexpr std::uint64_t packings = 8; // whose void ratios differ by 0.003
  const double radius = radius_of(values);
  const sizes::Distribution sizes = values.sizes.value_or(sizes::Distribution::equal());
  triaxial::SpecimenRecipe recipe{.material = {.law = law_of(values, grain_of(values), radius)},
                                  .radius = radius,
                                  .sizes = sizes,
                                  .grains = std::max(fewest, triaxial::least_grains(sizes))};
  if (values.preparation.pressure > 0)
    recipe.first_pressure = values.preparation.pressure;
  double sum = 0;
  for (recipe.seed = 1; recipe.seed <= packings; ++recipe.seed)
    sum += dem::void_ratio(triaxial::frictionless_specimen(recipe).state);
  return sum / static_cast<double>(packings);
}

} // namespace

OptionRow densest_row(std::string& densest) {
  return {.name = "--densest",
          .value = choice({"made"}, densest),
          .meaning =
              "For beads: make the densest packing of these grains, eight of 1000 without friction, in "
              "seconds, and estimate z* from the void ratio above theirs; packings of 500 grains are "
              "looser by 0.002, of 4000 denser by 0.004",
          .excludes = {{"--least-void-ratio"}}};
}

void make_densest(InputValues& values) {
  values.give(estimate::Input::least_void_ratio, made_void_ratio(values));
}

} // namespace granum::cli
