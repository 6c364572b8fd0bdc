// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/hardin/equation.hpp>

#include "unit.hpp"

TEST_CASE("points on a polynomial give its coefficients back, and no distance") {
  std::vector<double> x, y;
  for (int k = -10; k <= 10; ++k) {
    const double t = 0.2 * k;
    x.push_back(t);
    y.push_back(0.5 + 0.3 * t - 0.2 * t * t + 0.05 * t * t * t);
  }
  const hardin::Polynomial fit = hardin::fit_polynomial(x, y, 3);
  const double expected[] = {0.5, 0.3, -0.2, 0.05};
  REQUIRE(fit.coefficients.size() == 4);
  for (std::size_t k = 0; k < 4; ++k)
    CHECK(fit.coefficients[k] == relative(expected[k], 1e-12));
  CHECK(fit.rms < 1e-14);
}

TEST_CASE("the distance from a constant is the standard deviation") {
  const std::vector<double> x{0, 1, 2, 3}, y{1, 3, 1, 3};
  const hardin::Polynomial fit = hardin::fit_polynomial(x, y, 0);
  CHECK(fit.coefficients[0] == relative(2, 1e-14));
  CHECK(fit.rms == relative(1, 1e-14));
}

TEST_CASE("a polynomial of too few points, or none that there is, is refused") {
  const std::vector<double> x{0, 1, 2}, y{1, 2, 3}, two{1, 2};
  CHECK_THROWS_AS((void)hardin::fit_polynomial(x, y, 3), InvalidArgument);
  CHECK_THROWS_AS((void)hardin::fit_polynomial(x, two, 1), InvalidArgument);
  CHECK_THROWS_AS((void)hardin::fit_polynomial(x, y, 9), InvalidArgument);
}
