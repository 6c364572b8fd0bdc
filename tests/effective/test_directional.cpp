// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/uniform_field.hpp>

#include <granum/contact/rough_sphere.hpp>

#include "support.hpp"
#include "unit.hpp"

using namespace granum::test;

namespace {

/// Every shape, fabric, grain and stress ratio of the range that the library promises.
template <class Check>
void for_every_state(Check check) {
  for (const double alpha : {1.0, 1.3, 2.0, 5.0, 341.0, infinity})
    for (const double a : {-1.0, -0.35, 0.0, 0.6, 1.0})
      for (const double nu : {-0.999, 0.5}) // k_t/k_n from 2/3 to 4/3
        for (const double ratio : {0.1, 0.5, 1.0, 3.0, 10.0}) {
          CAPTURE(alpha);
          CAPTURE(a);
          CAPTURE(nu);
          CAPTURE(ratio);
          check(state_of(alpha, a, nu, ratio * 1e5, 1e5));
        }
}

} // namespace

TEST_CASE("direction-dependent stiffness: both estimates equal the sum over a dense grid of directions") {
  const auto check = [](const State& s, int along, double tolerance) {
    const auto directions = directions_of(s, along);
    const double P = contact_density(s);
    CHECK(difference(effective::uniform_strain(s).stiffness, stiffness_by_strain(P, directions)) < tolerance);
    CHECK(difference(effective::uniform_stress(s).stiffness, stiffness_by_stress(P, directions)) < tolerance);
  };
  for_every_state([&](const State& s) { check(s, 160, 1e-12); });
  for (const double alpha : {1.0, 1.3, 2.0}) {
    CAPTURE(alpha);
    for (const double ratio : {1e-3, 0.02, 50.0, 1e3}) // branch points close to the interval of the grid
      for (const double a : {-0.5, 0.5})
        check(state_of(alpha, a, 0.15, ratio * 1e5, 1e5), 1024, 1e-12);
    // Just inside the reach of each quadrature rule; a = 0: ratio of stresses and of forces.
    for (const double ratio : {1 / 3.999, 3.999, 1 / 39.99, 39.99})
      check(state_of(alpha, 0, 0.15, ratio * 1e5, 1e5), 200, 1e-13);
  }
  // Laws whose b changes with the force.
  for (const double roughness : {5e-9, 50e-9})
    for (const double a : {-0.3, 0.2})
      for (const double ratio : {0.3, 1.8, 10.0}) {
        State s = state_of(2, a, 0.15, ratio * 1e5, 1e5);
        s.law = contact::RoughSphere(s.law.grain(), s.radius, roughness);
        check(s, 400, 1e-7);
      }
}

TEST_CASE("direction-dependent stiffness: passes continuously into the closed form, and 0 without stress") {
  for (const auto estimate : {effective::uniform_strain, effective::uniform_stress}) {
    for (const double alpha : {1.0, 2.0, 7.0})
      CHECK(difference(estimate(state_of(alpha, 0, 0.15, 1e5 * (1 + 1e-15), 1e5)).stiffness,
                       estimate(state_of(alpha, 0, 0.15, 1e5, 1e5)).stiffness) < 1e-14);
    for (const double a : {-1.0, 0.0, 0.4}) {
      for (const double alpha : {1.0, 2.0, 341.0})
        CHECK(estimate(state_of(alpha, a, 0.15, 0, 0)).stiffness == elastic::TransverselyIsotropic{});
      CHECK(difference(estimate(state_of(infinity, a, 0.15, 0, 0)).stiffness,
                       estimate(state_of(infinity, a, 0.15, 3e5, 1e5)).stiffness) < 1e-13);
    }
  }
}

TEST_CASE("direction-dependent stiffness: notes travel with the estimate") {
  State s = state_of(2, 1.2, 0.15, 2e5, 1e5);
  CHECK(effective::uniform_strain(s).validity.notes.size() == 1);
  CHECK(effective::uniform_stress(s).validity.notes.size() == 1);
  s.fabric_anisotropy = 0;
  s.tangential_ratio = 0;
  CHECK(effective::uniform_strain(s).validity.ok());
  CHECK(effective::uniform_stress(s).validity.notes.size() == 1);
  CHECK(effective::uniform_stress(s).stiffness.G_vh() == 0);
  s.stress_v = -1;
  CHECK_THROWS_AS((void)effective::uniform_strain(s), InvalidArgument);
  CHECK_THROWS_AS((void)effective::uniform_stress(s), InvalidArgument);
}
