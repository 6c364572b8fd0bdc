// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/stress/stress.hpp>

#include "unit.hpp"

using namespace granum::stress;

namespace {

constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();

double end_of(ShearPath path) { return is_compression(path) ? 1 : -0.75; }

} // namespace

TEST_CASE("each path keeps its constant stress to the bit and reaches its stress ratio") {
  for (const ShearPath path : all_shear_paths)
    for (const double share : {0.05, 0.3, 0.7, 1.0}) {
      CAPTURE(name(path));
      const double eta = share * end_of(path);
      const AxialStress stress = stress_on_path(path, 100e3, eta);
      CHECK(stress.ratio() == relative(eta, 4 * rounding)); // v - h cancels at small eta
      const bool horizontal_constant = path == ShearPath::txc || path == ShearPath::rtxe;
      CHECK((horizontal_constant ? stress.h : stress.v) == 100e3);
    }
}

TEST_CASE("stresses of a path are those of its two linear equations") {
  // eta = 0.6: v = 1.4 p', h = 0.8 p'; eta = -0.6: v = 0.6 p', h = 1.2 p'
  CHECK(stress_on_path(ShearPath::txc, 80e3, 0.6).v == relative(140e3, rounding));
  CHECK(stress_on_path(ShearPath::txc, 80e3, 0.6).mean() == relative(100e3, rounding));
  CHECK(stress_on_path(ShearPath::rtxc, 140e3, 0.6).h == relative(80e3, rounding));
  CHECK(stress_on_path(ShearPath::rtxe, 120e3, -0.6).v == relative(60e3, rounding));
  CHECK(stress_on_path(ShearPath::txe, 60e3, -0.6).h == relative(120e3, rounding));
}

TEST_CASE("at the failure ratio the friction angle is mobilised") {
  for (const ShearPath path : all_shear_paths)
    for (const double degrees : {5.0, 26.5, 30.0, 60.0}) {
      CAPTURE(name(path));
      const double angle = degrees * std::numbers::pi / 180;
      const AxialStress s = stress_on_path(path, 100e3, failure_ratio(path, angle));
      CHECK(std::abs(s.v - s.h) / (s.v + s.h) == relative(std::sin(angle), 4 * rounding));
    }
  // sin 30 = 1/2: 6/5 and -6/7
  CHECK(failure_ratio(ShearPath::txc, std::numbers::pi / 6) == relative(1.2, rounding));
  CHECK(failure_ratio(ShearPath::txe, std::numbers::pi / 6) == relative(-6.0 / 7, rounding));
}

TEST_CASE("a ratio that a path does not reach, and an angle that no material has, are refused") {
  CHECK_THROWS_WITH_AS((void)stress_on_path(ShearPath::txc, 1e5, -0.1), doctest::Contains("eta = -0.1"),
                       InvalidArgument);
  CHECK_THROWS_AS((void)stress_on_path(ShearPath::rtxc, 1e5, 3), InvalidArgument);
  CHECK_THROWS_AS((void)stress_on_path(ShearPath::rtxe, 1e5, 0.1), InvalidArgument);
  CHECK_THROWS_AS((void)stress_on_path(ShearPath::txe, 1e5, -1.5), InvalidArgument);
  CHECK_THROWS_AS((void)stress_on_path(ShearPath::txc, 1e5, std::nan("")), InvalidArgument);
  CHECK_THROWS_AS((void)stress_on_path(ShearPath::txc, 0, 0), InvalidArgument);
  CHECK_THROWS_AS((void)failure_ratio(ShearPath::txc, 0), InvalidArgument);
  CHECK_THROWS_AS((void)failure_ratio(ShearPath::txc, 26.5), InvalidArgument);
}

TEST_CASE("no stress has the stress ratio 0") { CHECK(AxialStress{}.ratio() == 0); }

TEST_CASE("the mobilised friction angle is the inverse of the failure ratio, on every path") {
  for (const ShearPath path : all_shear_paths)
    for (const double angle : {0.02, 0.3, 0.46, 1.2}) {
      const AxialStress stress = stress_on_path(path, 100e3, failure_ratio(path, angle));
      CHECK(mobilised_friction_angle(stress) == relative(angle, 1e-13));
    }
  CHECK(mobilised_friction_angle({.v = 3, .h = 3}) == 0);
  for (const AxialStress& one : {AxialStress{.v = 3, .h = 0}, {.v = 0, .h = 3}})
    CHECK(mobilised_friction_angle(one) == relative(std::numbers::pi / 2, 1e-15));
  CHECK_THROWS_AS((void)mobilised_friction_angle({.v = -1, .h = 3}), InvalidArgument);
  CHECK_THROWS_AS((void)mobilised_friction_angle({.v = 0, .h = 0}), InvalidArgument);
}
