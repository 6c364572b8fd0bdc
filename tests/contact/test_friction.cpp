// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/contact/grains.hpp>

#include "unit.hpp"

using contact::Friction;

TEST_CASE("friction angle and coefficient convert into each other") {
  constexpr double degree = std::numbers::pi / 180;
  CHECK(Friction::from_angle(26.5 * degree).coefficient() ==
        doctest::Approx(0.49858).epsilon(2e-5)); // 5 digits
  CHECK(Friction::from_angle(45 * degree).coefficient() == doctest::Approx(1).epsilon(4e-16));
  CHECK(Friction::from_coefficient(0).angle() == 0);
  for (double angle = 0; angle < 1.5; angle += 0.1) // tan and atan round once each
    CHECK(Friction::from_angle(angle).angle() == doctest::Approx(angle).epsilon(4e-16));
}

TEST_CASE("impossible friction is refused") {
  for (const double bad : {-0.1, std::numeric_limits<double>::quiet_NaN()}) {
    CHECK_THROWS_AS((void)Friction::from_coefficient(bad), InvalidArgument);
    CHECK_THROWS_AS((void)Friction::from_angle(bad), InvalidArgument);
  }
  CHECK_THROWS_AS((void)Friction::from_angle(26.5), InvalidArgument); // degrees
}
