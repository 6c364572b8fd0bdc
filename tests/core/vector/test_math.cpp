// SPDX-License-Identifier: GPL-3.0-or-later
#include "effective/vector_math.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <doctest/doctest.h>
#include <granum/effective/batch.hpp>

#include "support.hpp"

using namespace granum;
namespace vm = granum::effective::vector_math;

namespace {

long double exactly(double x) { return x; }

/// Error of `value` in units of the last place of the exact number, which long double knows 11 bits better.
double ulps(double value, long double exact) {
  const double nearest = static_cast<double>(exact);
  const double place = std::nextafter(nearest, test::infinity) - nearest;
  return static_cast<double>(std::abs(exactly(value) - exact) / exactly(place));
}

double cube_root(double x) {
  return vm::cube_root_from(x, vm::inverse_cube_root_step(x, vm::inverse_cube_root_guess(x)));
}

double power(double x, double b) { return vm::power_from(vm::log2_of(x), vm::exponent(b)); }

/// Mantissas in fine steps at exponents from the smallest normal number to the largest.
template <class Check>
void for_many_numbers(Check check) {
  for (int exponent = -1022; exponent < 1023; exponent += 31)
    for (int third = 0; third < 3; ++third) // a cube root sees the exponent modulo 3
      for (int step = 0; step < 400; ++step)
        check(std::ldexp(1 + (step + 0.137) / 400, std::min(exponent + third, 1023)));
}

} // namespace

TEST_CASE("vector math: cube roots of normal numbers within 1 ulp, of 0 exactly 0") {
  double worst = 0;
  for_many_numbers([&](double x) { worst = std::max(worst, ulps(cube_root(x), std::cbrt(exactly(x)))); });
  CHECK(worst < 1);
  CHECK(cube_root(0) == 0);
  CHECK(cube_root(27) == 3);
  CHECK(cube_root(std::numeric_limits<double>::min()) > 0);
}

TEST_CASE("vector math: the guess of the inverse cube root keeps within the interval of its step") {
  double least = 0, largest = 0;
  for_many_numbers([&](double x) {
    const double r = vm::inverse_cube_root_guess(x);
    const double h = 1 - x * r * r * r;
    least = std::min(least, h);
    largest = std::max(largest, h);
  });
  CHECK(least > -0.1022); // 0.1021 and the rounding of the 40 bits that the guess keeps
  CHECK(largest < 0.1022);
}

TEST_CASE("vector math: powers with the exponents of contact laws within 1.5 ulp") {
  for (const double b : {0.5, 0.4, 1.0 / 3, 0.25, 1.0 / 9, 1.0 / 301, 1e-9}) {
    double worst = 0;
    for_many_numbers(
        [&](double x) { worst = std::max(worst, ulps(power(x, b), std::pow(exactly(x), exactly(b)))); });
    CAPTURE(b);
    CHECK(worst < 1.5);
  }
}

TEST_CASE("vector math: the batch, at whatever vector level it runs here, has the bits of plain code") {
  const contact::PowerLaw law = test::law_of(2, 0.15);
  constexpr double R = 5e-4;
  const double c =
      law.stiffness_at_force(4 * std::numbers::pi * R * R) / (6 * std::numbers::pi * R) * 0x1p-60;
  std::vector<double> pressure, contacts, porosity;
  for (int k = 0; k < 5000; ++k) {
    pressure.push_back(std::pow(10, -12 + std::fmod(0.7331 * k, 24)));
    contacts.push_back(0.1 + std::fmod(0.613 * k, 13));
    porosity.push_back(0.05 + std::fmod(0.1717 * k, 0.9));
  }
  std::vector<double> bulk(5000), shear(5000);
  REQUIRE(effective::uniform_strain({law, 0.8, R, pressure, contacts, porosity}, {bulk, shear}).ok());
  bool same = true;
  for (std::size_t k = 0; k < bulk.size(); ++k) {
    const double w = contacts[k] * (1 - porosity[k]);
    same = same && bulk[k] == c * cube_root(w * w * (pressure[k] * 0x1p180));
  }
  CHECK(same);
}
