// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/core/numerics.hpp>

#include "unit.hpp"

TEST_CASE("Gauss-Legendre rules integrate polynomials up to degree 2 n - 1 exactly and no further") {
  for (const int order : {1, 2, 3, 7, 16, 48, 101}) {
    CAPTURE(order);
    const auto rule = gauss_legendre(order);
    REQUIRE(rule.size() == static_cast<std::size_t>(order));
    const auto integral = [&](int degree) {
      double sum = 0;
      for (const auto& [x, w] : rule)
        sum += w * std::pow(x, degree);
      return sum;
    };
    for (int degree = 0; degree < 2 * order; ++degree) // rounding of n terms of sum 2
      CHECK(std::abs(integral(degree) - (degree % 2 == 0 ? 2.0 / (degree + 1) : 0.0)) < 2e-15);
    if (order <= 7)
      CHECK(std::abs(integral(2 * order) - 2.0 / (2 * order + 1)) > 1e-5);
  }
}

TEST_CASE("Gauss-Legendre rules are ascending, symmetric and positive") {
  for (const int order : {2, 15, 256}) {
    const auto rule = gauss_legendre(order);
    for (std::size_t i = 0; i < rule.size(); ++i) {
      const auto& mirror = rule[rule.size() - 1 - i];
      CHECK(rule[i].weight > 0);
      CHECK(rule[i].abscissa == -mirror.abscissa);
      CHECK(rule[i].weight == mirror.weight);
      if (i > 0)
        CHECK(rule[i].abscissa > rule[i - 1].abscissa);
    }
  }
  CHECK(gauss_legendre(3)[2].abscissa == doctest::Approx(std::sqrt(0.6)).epsilon(2e-16));
  CHECK(gauss_legendre(3)[1].abscissa == 0);
  for (const int bad : {0, -3, 1025})
    CHECK_THROWS_AS((void)gauss_legendre(bad), InvalidArgument);
}
