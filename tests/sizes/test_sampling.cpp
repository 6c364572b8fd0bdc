// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/sizes/distribution.hpp>

#include <numeric>
#include <random>

#include "unit.hpp"

using namespace granum::sizes;

namespace {

double sampled_moment(const std::vector<double>& radii, double k) {
  double sum = 0;
  for (const double x : radii)
    sum += std::pow(x, k);
  return sum / static_cast<double>(radii.size());
}

} // namespace

TEST_CASE("moments of plain draws are those of the distribution within their standard errors") {
  constexpr std::size_t count = 20000;
  for (const Distribution& sizes :
       {Distribution::bidisperse(1.4), Distribution::uniform(1, 3), Distribution::lognormal(0.35),
        Distribution::power_law(3.5, 5), Distribution::uniformity(2)})
    for (const double k : {1.0, 2.0, 3.0}) {
      CAPTURE(sizes.text());
      CAPTURE(k);
      const double mean = sizes.moment(k);
      const double error = std::sqrt((sizes.moment(2 * k) - mean * mean) / count);
      CHECK(std::abs(sampled_moment(sample_radii(sizes, count, 7, Drawing::plain), k) - mean) < 3.5 * error);
    }
}

TEST_CASE("stratified draws have moments far nearer than plain ones, and all sizes in disorder") {
  constexpr std::size_t count = 1000;
  for (const Distribution& sizes : {Distribution::uniform(1, 3), Distribution::lognormal(0.35)}) {
    CAPTURE(sizes.text());
    const std::vector<double> radii = sample_radii(sizes, count, 3);
    CHECK(sampled_moment(radii, 1) == relative(1, 1e-4));
    CHECK(sampled_moment(radii, 3) == relative(sizes.moment(3), 2e-3));
    std::vector<double> sorted = radii;
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t k = 0; k < count; ++k) {
      CHECK(sizes.share_below(sorted[k]) >= static_cast<double>(k) / count - 1e-12);
      CHECK(sizes.share_below(sorted[k]) <= static_cast<double>(k + 1) / count + 1e-12);
    }
    const double neighbours =
        std::inner_product(radii.begin() + 1, radii.end(), radii.begin(), 0.0) / (count - 1);
    CHECK(std::abs(neighbours - 1) <
          4 * (sizes.moment(2) - 1) / std::sqrt(count)); // no order from place to place
  }
}

TEST_CASE("one seed is one sample, and equal grains are equal") {
  const Distribution sizes = Distribution::lognormal(0.35);
  CHECK(sample_radii(sizes, 100, 5) == sample_radii(sizes, 100, 5));
  CHECK(sample_radii(sizes, 100, 5) != sample_radii(sizes, 100, 6));
  const std::vector<double> longer = sample_radii(sizes, 100, 5, Drawing::plain);
  const std::vector<double> shorter = sample_radii(sizes, 40, 5, Drawing::plain);
  CHECK(std::equal(shorter.begin(), shorter.end(), longer.begin()));
  CHECK(sample_radii(sizes, 0, 5).empty());
  CHECK(sample_radii(Distribution::equal(), 3, 5) == std::vector<double>{1, 1, 1});
  const std::vector<double> two = sample_radii(Distribution::bidisperse(1.4), 1000, 11); // half of it large
  CHECK(std::count(two.begin(), two.end(), *std::max_element(two.begin(), two.end())) == 500);
}

TEST_CASE("the bits of a sample do not depend on the vendor of the standard library") {
  // Of uniform grains, sums and products alone stand between the radius and the bits, which the standard
  // fixes.
  std::mt19937_64 bits(1);
  const Distribution sizes = Distribution::uniform(1, 3);
  for (const double radius : sample_radii(sizes, 3, 1, Drawing::plain)) {
    const double share = std::ldexp(static_cast<double>(bits()), -64);
    CHECK(radius == sizes.smallest() + share * (sizes.largest() - sizes.smallest()));
  }
}
