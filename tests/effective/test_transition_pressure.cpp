// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/state.hpp>

#include "support.hpp"
#include "unit.hpp"

using namespace granum::test;

TEST_CASE("the pressure of the transition: X is 1 at the mean force, in closed form and by number") {
  State s = state_of(2, 0, 0.074, 1e5, 1e5);
  CHECK_FALSE(effective::transition_pressure(s).has_value());
  const double G = 44e9, nu = 0.074, R = 0.1e-3, u0 = 10e-9;
  s.radius = R;
  s.void_ratio = 0.7;
  s.coordination_number = 5;
  s.law = contact::RoughSphere({.shear_modulus = G, .poisson_ratio = nu}, R, u0);
  const double p = effective::transition_pressure(s).value();
  const double by_hand =
      std::sqrt(3) / (4 * std::numbers::pi) * 5 / 1.7 * G / (1 - nu) * std::pow(u0 / R, 1.5);
  CHECK(p == relative(by_hand, 1e-12));
  CHECK(p == relative(19e3, 0.02)); // the number that the theory page has
  s.stress_v = s.stress_h = p;
  const double f = effective::mean_contact_force(s);
  CHECK(u0 * s.law.closing_law().stiffness_at_force(f) / f == relative(1, 1e-12));
  s.coordination_number = 0;
  CHECK_THROWS_AS((void)effective::transition_pressure(s), InvalidArgument);
}

TEST_CASE("the pressure of the transition follows from the exponent of rough spheres at another pressure") {
  const contact::RoughSphere law({.shear_modulus = 44e9, .poisson_ratio = 0.074}, 0.1e-3, 20e-9);
  for (const double p : {1e3, 20e3, 100e3, 3e6}) {
    State s = state_of(2, 0, 0.074, p, p);
    s.law = law;
    s.radius = 0.1e-3;
    const double b = s.law.exponent_at_force(effective::mean_contact_force(s));
    const double transition = effective::transition_pressure_of(b, p);
    CHECK(transition == relative(*effective::transition_pressure(s), 1e-9));
    CHECK(effective::roughness_of(s, transition) == relative(20e-9, 1e-8));
    CHECK_THROWS_AS((void)effective::roughness_of(s, 0), InvalidArgument);
  }
  for (const double s : {0.0, 1.0 / 3, 1.0, 1.2, std::nan("")})
    CHECK_THROWS_AS((void)effective::transition_pressure_of(s, 1e5), InvalidArgument);
  CHECK_THROWS_AS((void)effective::transition_pressure_of(0.5, 0), InvalidArgument);
}
