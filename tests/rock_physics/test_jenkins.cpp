// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/rock_physics/sphere_packs.hpp>

#include "unit.hpp"

using rock_physics::jenkins_shear_factor;
using rock_physics::jenkins_shear_modulus;
using rock_physics::SpherePacking;

namespace {

SpherePacking frictionless(double k) {
  return {.shear_modulus = 45e9,
          .poisson_ratio = 0.07,
          .porosity = 0.36,
          .coordination_number = k,
          .pressure = 1e6,
          .no_slip_fraction = 0};
}

} // namespace

TEST_CASE("jenkins: shear factors as evaluated elsewhere") {
  // Printed with three digits.
  for (const auto& [k, factor] :
       {std::pair{5.5, 0.149}, {6.0, 0.298}, {6.5, 0.422}, {7.0, 0.526}, {8.0, 0.690}, {9.0, 0.814}})
    CHECK(std::abs(jenkins_shear_factor(k) - factor) <= 0.0005);
}

TEST_CASE("jenkins: G grows from above zero to below its upper bound") {
  double last = 0;
  for (double k = 5.1; k <= 11; k += 0.01) {
    CHECK(jenkins_shear_factor(k) > last);
    last = jenkins_shear_factor(k);
  }
  CHECK(last > 0.98);
  CHECK(last < 1);
}

TEST_CASE("jenkins: scales the smooth packing, and is refused outside its domain") {
  auto unloaded = frictionless(6);
  unloaded.pressure = 0;
  CHECK(jenkins_shear_modulus(unloaded) == 0);
  CHECK(
      jenkins_shear_modulus(frictionless(6)) ==
      relative(jenkins_shear_factor(6) * rock_physics::hertz_mindlin(frictionless(6)).shear_modulus, 4e-16));
  for (const double k : {0.0, 3.0, 5.0, 5.09, 11.1, std::numeric_limits<double>::quiet_NaN()}) {
    CHECK_THROWS_AS((void)jenkins_shear_factor(k), InvalidArgument);
    CHECK_THROWS_AS((void)jenkins_shear_modulus(frictionless(k)), InvalidArgument);
  }
  auto rough = frictionless(6);
  rough.no_slip_fraction = 1;
  CHECK_THROWS_AS((void)jenkins_shear_modulus(rough), InvalidArgument);
}
