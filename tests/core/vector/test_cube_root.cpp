// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/vector/power.hpp"

#include "core/vector/ulps.hpp"
#include "unit.hpp"

namespace {

using test::ulps;

long double exactly(double x) { return x; }

double cube_root(double x) {
  return cube_root_from(x, inverse_cube_root_step(x, inverse_cube_root_guess(x)));
}

/// Mantissas in fine steps at exponents from the smallest normal number to the largest.
template <class Check>
void for_many_numbers(Check check) {
  for (int exponent = -1022; exponent < 1023; exponent += 31)
    for (int third = 0; third < 3; ++third) // a cube root sees the exponent modulo 3
      for (int step = 0; step < 400; ++step)
        check(std::ldexp(1 + (step + 0.137) / 400, std::min(exponent + third, 1023)));
}

} // namespace

TEST_CASE("cube roots of normal numbers within 1 ulp, of 0 exactly 0") {
  double worst = 0;
  for_many_numbers([&](double x) { worst = std::max(worst, ulps(cube_root(x), std::cbrt(exactly(x)))); });
  CHECK(worst < 1);
  CHECK(cube_root(0) == 0);
  CHECK(cube_root(27) == 3);
  CHECK(cube_root(std::numeric_limits<double>::min()) > 0);
}

TEST_CASE("the guess of the inverse cube root keeps within the interval of its step") {
  double least = 0, largest = 0;
  for_many_numbers([&](double x) {
    const double r = inverse_cube_root_guess(x);
    const double h = 1 - x * r * r * r;
    least = std::min(least, h);
    largest = std::max(largest, h);
  });
  CHECK(least > -0.1022); // 0.1021 and the rounding of the 40 bits that the guess keeps
  CHECK(largest < 0.1022);
}
