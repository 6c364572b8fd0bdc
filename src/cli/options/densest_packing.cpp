// SPDX-License-Identifier: GPL-3.0-or-later
#include "densest_packing.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <granum/core/error.hpp>
#include <granum/triaxial/specimen.hpp>

namespace granum::cli {

namespace {

using estimate::InputValues;

struct Mean {
  double value = 0, error = 0; ///< error: standard error of the mean
};

/// The mean void ratio of packings of these grains that are compressed without friction.
Mean made_void_ratio(const InputValues& values) {
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
  double sum = 0, squares = 0;
  for (recipe.seed = 1; recipe.seed <= packings; ++recipe.seed) {
    const double e = dem::void_ratio(triaxial::frictionless_specimen(recipe).state);
    sum += e;
    squares += e * e;
  }
  constexpr double n = packings;
  const double mean = sum / n;
  return {.value = mean, .error = std::sqrt(std::max(squares / n - mean * mean, 0.0) / (n - 1))};
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
  const Mean mean = made_void_ratio(values);
  values.give(estimate::Input::least_void_ratio, mean.value);
  values.set_deviation(estimate::Input::least_void_ratio, mean.error);
}

} // namespace granum::cli
