// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/fabric/orientation.hpp>

#include <granum/core/numerics.hpp>

#include "unit.hpp"

namespace {

constexpr double place = std::numeric_limits<double>::epsilon();

} // namespace

TEST_CASE("polar distribution: the probability is the density over the two caps beyond t taken from one") {
  for (double a = -1; a <= 1; a += 0.125)
    for (const double t : {0.01, 0.3, 0.5, 0.9, 1.0}) {
      double share = 0; // 4 pi t times the mean of E over |n3| < t, a polynomial of degree 2
      for (const auto& [x, w] : gauss_legendre(8))
        share += 4 * std::numbers::pi * t * w / 2 * fabric::density(std::acos(t * (1 + x) / 2), a);
      CHECK(std::abs(fabric::cumulative_probability(t, a) - share) < 1e-15);
    }
  for (const double a : {-1.0, 0.3, 1.0}) {
    CHECK(fabric::cumulative_probability(0, a) == 0);
    CHECK(fabric::polar_cosine_quantile(0, a) == 0);
    CHECK(fabric::polar_cosine_quantile(1, a) == 1);
    CHECK(fabric::cumulative_probability(1, a) == relative(1, place));
  }
}

TEST_CASE("polar distribution: the quantile undoes the probability over all of a and p") {
  for (const double a : {-1.0, -1 + 1e-12, -0.7, -1e-3, -1e-300, 0.0, 1e-300, 1e-12, 0.4, 1 - 1e-12, 1.0})
    for (const double p : {1e-300, 1e-15, 1e-6, 0.1, 0.5, 0.9, 1 - 1e-6, 1 - 1e-15, 1.0}) {
      CAPTURE(a);
      CAPTURE(p);
      const double t = fabric::polar_cosine_quantile(p, a);
      CHECK(t >= 0);
      CHECK(t <= 1);
      CHECK(fabric::cumulative_probability(t, a) == relative(p, 1e-15));
    }
}

TEST_CASE("polar distribution: bad input") {
  CHECK_THROWS_AS((void)fabric::cumulative_probability(1.1, 0), InvalidArgument);
  CHECK_THROWS_AS((void)fabric::cumulative_probability(0.5, 1.1), InvalidArgument);
  CHECK_THROWS_AS((void)fabric::polar_cosine_quantile(-0.1, 0), InvalidArgument);
  CHECK_THROWS_AS((void)fabric::polar_cosine_quantile(0.5, -1.1), InvalidArgument);
  CHECK_THROWS_AS((void)fabric::polar_cosine_quantile(std::nan(""), 0), InvalidArgument);
}
