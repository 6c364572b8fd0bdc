// SPDX-License-Identifier: GPL-3.0-or-later
#include <least_squares.hpp>

#include "unit.hpp"

using namespace relaxation;

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// Rows of a e^(bx), a = 3 and b = -0.5.
std::vector<Observation<2>> decay() {
  std::vector<Observation<2>> rows;
  for (const double x : {0.0, 0.5, 1.0, 2.0, 3.0})
    rows.push_back({[x](const Numbers<Dual<2>, 2>& c) { return Dual<2>(c[0] * exp(Dual<2>(c[1] * x))); },
                    3 * std::exp(-0.5 * x), 1, "x = " + std::to_string(x)});
  return rows;
}

} // namespace

TEST_CASE("least squares: the coefficients of synthetic rows are found") {
  const Fit<2> fit = least_squares<2>(decay(), {1, 0});
  CHECK(fit.coefficients[0] == doctest::Approx(3).epsilon(1e-10));
  CHECK(fit.coefficients[1] == doctest::Approx(-0.5).epsilon(1e-10));
}

TEST_CASE("least squares: a row that is no number is named") {
  std::vector<Observation<2>> rows = decay();
  rows[3].target = no_number;
  CHECK_THROWS_WITH_AS((void)least_squares<2>(rows, {1, 0}), doctest::Contains("x = 2"),
                       std::invalid_argument);
}
