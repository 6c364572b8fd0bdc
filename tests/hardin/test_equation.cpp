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

TEST_CASE("at the atmospheric pressure the modulus is C p_a f(e)") {
  Equation equation = sand;
  CHECK(shear_modulus(equation, {1e5, 1e5, 0.6}) == 700e5);
  equation.void_ratio_function = VoidRatioFunction::hardin_richart_round;
  CHECK(shear_modulus(equation, {1e5, 1e5, 0.6}) == relative(700e5 * 1.57 * 1.57 / 1.6, rounding));
}

TEST_CASE("each stress has its own exponent") {
  const double g = shear_modulus(sand, {1e5, 1e5, 0.6});
  CHECK(shear_modulus(sand, {2e5, 1e5, 0.6}) / g == relative(std::pow(2.0, 0.27), rounding));
  CHECK(shear_modulus(sand, {1e5, 2e5, 0.6}) / g == relative(std::pow(2.0, 0.23), rounding));
  CHECK(shear_modulus(sand, {8e5, 8e5, 0.6}) / g == relative(std::pow(8.0, 0.5), rounding));
}

TEST_CASE("another atmospheric pressure changes C by its power 1 - s, never the modulus") {
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
