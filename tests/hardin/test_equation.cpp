// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/hardin/equation.hpp>

#include "unit.hpp"

using namespace granum::hardin;

namespace {

const Equation sand{.coefficient = 700,
                    .exponent_i = 0.27,
                    .exponent_j = 0.23,
                    .atmospheric_pressure = 1e5,
                    .void_ratio_function = VoidRatioFunction::none};
constexpr double rounding = 1e-14; // three powers and products

} // namespace

TEST_CASE("the modulus is C p_a f(e) with an exponent of each stress, in any atmospheric pressure") {
  Equation equation = sand;
  CHECK(shear_modulus(equation, {1e5, 1e5, 0.6}) == 700e5);
  equation.void_ratio_function = VoidRatioFunction::hardin_richart_round;
  CHECK(shear_modulus(equation, {1e5, 1e5, 0.6}) == relative(700e5 * 1.57 * 1.57 / 1.6, rounding));
  const double g = shear_modulus(sand, {1e5, 1e5, 0.6});
  CHECK(shear_modulus(sand, {2e5, 1e5, 0.6}) / g == relative(std::pow(2.0, 0.27), rounding));
  CHECK(shear_modulus(sand, {1e5, 2e5, 0.6}) / g == relative(std::pow(2.0, 0.23), rounding));
  CHECK(shear_modulus(sand, {8e5, 8e5, 0.6}) / g == relative(std::pow(8.0, 0.5), rounding));
  Equation other = sand;
  other.atmospheric_pressure = 101325;
  other.coefficient = 700 * std::pow(1e5 / 101325, 1 - 0.5);
  CHECK(shear_modulus(other, {3e5, 4e4, 0.6}) == relative(shear_modulus(sand, {3e5, 4e4, 0.6}), rounding));
}

TEST_CASE("constants and states outside their range are refused") {
  for (const auto& [member, value] : {std::pair{&Equation::atmospheric_pressure, 0.0},
                                      {&Equation::coefficient, -1.0},
                                      {&Equation::exponent_j, double(NAN)}}) {
    Equation bad = sand;
    bad.*member = value;
    CHECK_THROWS_AS((void)shear_modulus(bad, {1e5, 1e5, 0.6}), InvalidArgument);
  }
  for (const SoilState& bad : {SoilState{-1e5, 1e5, 0.6}, {1e5, 0, 0.6}, {1e5, 1e5, 0}})
    CHECK_THROWS_AS((void)shear_modulus(sand, bad), InvalidArgument);
}

TEST_CASE("values worked by hand at e = 0.5 and e = 1") {
  const double ulps = 1e-15;
  CHECK(void_ratio_value(VoidRatioFunction::hardin_richart_round, 0.5) == relative(1.67 * 1.67 / 1.5, ulps));
  CHECK(void_ratio_value(VoidRatioFunction::hardin_richart_angular, 0.5) ==
        relative(2.47 * 2.47 / 1.5, ulps));
  CHECK(void_ratio_value(VoidRatioFunction::hardin_blandford, 0.5) == relative(1 / 0.475, ulps));
  CHECK(void_ratio_value(VoidRatioFunction::power_1_3, 0.5) == relative(2 * std::pow(2.0, 0.3), ulps));
  CHECK(void_ratio_value(VoidRatioFunction::power_1_3, 1) == 1);
  CHECK(void_ratio_value(VoidRatioFunction::hardin_blandford, 1) == 1);
  CHECK(void_ratio_value(VoidRatioFunction::none, 0.5) == 1);
}

TEST_CASE("every function falls with void ratio, but for none, and is found by its name") {
  for (const VoidRatioFunction function : all_void_ratio_functions())
    for (double e = 0.1; e < 2; e += 0.1) {
      CAPTURE(name(function));
      const double step = void_ratio_value(function, e) - void_ratio_value(function, e + 0.1);
      CHECK((function == VoidRatioFunction::none ? step == 0 : step > 0));
    }
  for (const VoidRatioFunction function : all_void_ratio_functions())
    CHECK(void_ratio_function(name(function)) == function);
  CHECK_THROWS_WITH_AS((void)void_ratio_function("hardin"), doctest::Contains("'hardin'"), InvalidArgument);
}

TEST_CASE("void ratios outside the range are refused") {
  for (const VoidRatioFunction function : all_void_ratio_functions())
    for (const double e : {0.0, -0.5, double(NAN), std::numeric_limits<double>::infinity()})
      CHECK_THROWS_AS((void)void_ratio_value(function, e), InvalidArgument);
  CHECK_THROWS_AS((void)void_ratio_value(VoidRatioFunction::hardin_richart_round, 2.17), InvalidArgument);
  CHECK_THROWS_AS((void)void_ratio_value(VoidRatioFunction::hardin_richart_angular, 3), InvalidArgument);
}

TEST_CASE("points on a polynomial give its coefficients back, and no distance") {
  std::vector<double> x, y;
  for (int k = -10; k <= 10; ++k) {
    const double t = 0.2 * k;
    x.push_back(t);
    y.push_back(0.5 + 0.3 * t - 0.2 * t * t + 0.05 * t * t * t);
  }
  const Polynomial fit = fit_polynomial(x, y, 3);
  const double expected[] = {0.5, 0.3, -0.2, 0.05};
  REQUIRE(fit.coefficients.size() == 4);
  for (std::size_t k = 0; k < 4; ++k)
    CHECK(fit.coefficients[k] == relative(expected[k], 1e-12));
  CHECK(fit.rms < 1e-14);
}

TEST_CASE("the distance from a constant is the standard deviation") {
  const std::vector<double> x{0, 1, 2, 3}, y{1, 3, 1, 3};
  const Polynomial fit = fit_polynomial(x, y, 0);
  CHECK(fit.coefficients[0] == relative(2, 1e-14));
  CHECK(fit.rms == relative(1, 1e-14));
}

TEST_CASE("a polynomial of too few points, or none that there is, is refused") {
  const std::vector<double> x{0, 1, 2}, y{1, 2, 3}, two{1, 2};
  CHECK_THROWS_AS((void)fit_polynomial(x, y, 3), InvalidArgument);
  CHECK_THROWS_AS((void)fit_polynomial(x, two, 1), InvalidArgument);
  CHECK_THROWS_AS((void)fit_polynomial(x, y, 9), InvalidArgument);
}
