// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/contact/shape.hpp>

#include <cmath>
#include <limits>
#include <numbers>

#include <doctest/doctest.h>
#include <granum/core/error.hpp>

#include "relative.hpp"

using namespace granum;
using namespace granum::contact;

namespace {

constexpr GrainMaterial grain{30e9, 0.15};
constexpr ShapeParameters parameters{
    .radius = 0.4e-3, .cone_slope = 0.3, .punch_radius = 6e-6, .alpha = 3, .profile_constant = 5e6};

} // namespace

TEST_CASE("each shape has a name of its own, which finds it again") {
  for (const Shape shape : all_shapes) {
    CHECK(find_shape(name(shape)) == shape);
    for (const Shape other : all_shapes)
      CHECK((name(shape) == name(other)) == (shape == other));
  }
  CHECK(shape_names() == "cone, sphere, flat, power-law");
  for (const char* text : {"", "Cone", "cone ", "power_law", "cube", "con"})
    CHECK_FALSE(find_shape(text).has_value());
}

TEST_CASE("each shape has the law of its profile, by hand") {
  // Two grains of modulus M = G/(1-nu), full approach d: cone f = M d^2/(pi A), sphere f = 2/3 M sqrt(2R)
  // d^(3/2), flat f = 2 M a d.                                                       [Hertz1882; Sneddon1965]
  const double M = 30e9 / 0.85, d = 1e-7;
  CHECK(law_of(Shape::cone, grain, parameters).force(d) ==
        relative(M * d * d / (std::numbers::pi * 0.3), 1e-14));
  CHECK(law_of(Shape::sphere, grain, parameters).force(d) ==
        relative(2.0 / 3 * M * std::sqrt(2 * 0.4e-3) * d * std::sqrt(d), 1e-14));
  CHECK(law_of(Shape::flat, grain, parameters).force(d) == relative(2 * M * 6e-6 * d, 1e-14));
  CHECK(law_of(Shape::power_law, grain, parameters).alpha() == 3);
  CHECK(law_of(Shape::power_law, grain, parameters).profile_constant() == relative(5e6, 1e-13));
}

TEST_CASE("a shape reads its own parameters alone, and refuses them by their name") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(law_of(Shape::cone, grain, {.radius = nan, .cone_slope = 0.3}).alpha() == 1);
  CHECK(law_of(Shape::sphere, grain, {.radius = 0.4e-3, .punch_radius = nan}).alpha() == 2);
  CHECK_THROWS_AS((void)law_of(Shape::cone, grain, {.radius = 0.4e-3}), InvalidArgument);
  CHECK_THROWS_WITH((void)law_of(Shape::sphere, grain, {}), doctest::Contains("radius = 0 m"));
  CHECK_THROWS_WITH((void)law_of(Shape::flat, grain, {}), doctest::Contains("punch_radius = 0 m"));
  CHECK_THROWS_WITH((void)law_of(Shape::power_law, grain, {}), doctest::Contains("alpha = 0"));
}

TEST_CASE("a number that is no shape is refused") {
  CHECK_THROWS_AS((void)name(static_cast<Shape>(17)), InvalidArgument);
  CHECK_THROWS_AS((void)law_of(static_cast<Shape>(17), grain, parameters), InvalidArgument);
}
