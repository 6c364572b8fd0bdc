// SPDX-License-Identifier: GPL-3.0-or-later
#include <scatter.hpp>

#include <random>

#include "unit.hpp"

using namespace relaxation;

namespace {

/// Deviations of variance known + measure (0.05^2 + 0.2^2 s^2), s the sensitivity.
std::vector<Deviation> drawn(double known, double measure) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  std::vector<Deviation> all;
  for (int k = 0; k < 20000; ++k) {
    const double s = 0.5 * (k % 3);
    const double variance = known + measure * (0.0025 + 0.04 * s * s);
    const double error = std::sqrt(variance) * normal(random);
    all.push_back(
        {.squared = error * error, .squared_sensitivity = s * s, .known = known, .measure = measure});
  }
  return all;
}

} // namespace

TEST_CASE("scatter: base and gain are found, also with an additional known scatter") {
  for (const double known : {0.0, 0.001})
    for (const double measure : {1.0, 0.3}) {
      const Scatter found = most_likely_scatter(drawn(known, measure));
      CHECK(found.base == doctest::Approx(0.05).epsilon(0.03)); // 20,000 draws: 1 to 2 %
      CHECK(found.gain == doctest::Approx(0.2).epsilon(0.03));
    }
}

TEST_CASE("scatter: known scatter is not counted again") {
  std::vector<Deviation> deviations = drawn(0.001, 0);
  for (Deviation& d : deviations)
    d.measure = 1;
  const Scatter found = most_likely_scatter(deviations);
  CHECK(found.base * found.base < 6e-5); // 20,000 draws: 2e-5
  CHECK(found.gain * found.gain < 6e-5);
}
