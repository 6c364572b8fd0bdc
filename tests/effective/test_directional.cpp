// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/uniform_field.hpp>

#include <cmath>

#include <doctest/doctest.h>
#include <granum/core/error.hpp>

#include "support.hpp"

using namespace granum;
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
  double worst = 0;
  for_every_state([&](const State& s) {
    const auto directions = directions_of(s);
    const double P = contact_density(s);
    const double strain =
        difference(effective::uniform_strain(s).stiffness, stiffness_by_strain(P, directions));
    const double stress =
        difference(effective::uniform_stress(s).stiffness, stiffness_by_stress(P, directions));
    CHECK(strain < 1e-12);
    CHECK(stress < 1e-12);
    worst = std::max({worst, strain, stress});
  });
  MESSAGE("largest relative difference: ", worst);
}

TEST_CASE("direction-dependent stiffness: beyond the usual stress ratios") {
  for (const double ratio : {1e-3, 0.02, 50.0, 1e3})
    for (const double alpha : {1.0, 2.0})
      for (const double a : {-0.5, 0.5}) {
        CAPTURE(ratio);
        const State s = state_of(alpha, a, 0.15, ratio * 1e5, 1e5);
        const auto directions = directions_of(s, 1024); // branch points close to the interval of the grid
        const double P = contact_density(s);
        CHECK(difference(effective::uniform_strain(s).stiffness, stiffness_by_strain(P, directions)) < 1e-12);
        CHECK(difference(effective::uniform_stress(s).stiffness, stiffness_by_stress(P, directions)) < 1e-12);
      }
}

TEST_CASE("direction-dependent stiffness: just inside the reach of each quadrature rule") {
  for (const double ratio : {1 / 3.999, 3.999, 1 / 39.99, 39.99}) // a = 0: ratio of stresses and of forces
    for (const double alpha : {1.0, 1.3, 2.0}) {
      const State s = state_of(alpha, 0, 0.15, ratio * 1e5, 1e5);
      const auto directions = directions_of(s, 200);
      const double P = contact_density(s);
      CHECK(difference(effective::uniform_strain(s).stiffness, stiffness_by_strain(P, directions)) < 1e-13);
      CHECK(difference(effective::uniform_stress(s).stiffness, stiffness_by_stress(P, directions)) < 1e-13);
    }
}

TEST_CASE("direction-dependent stiffness: bulk modulus of cones in closed form") {
  // k_n = k_1 sqrt f, isotropic fabric: <k_n> = k_1 int_0^1 sqrt(A + (B-A) x^2) dx with the forces A and B of
  // horizontal and vertical contacts, up to the largest ratio that is taken.
  for (const double ratio : {1e-4, 0.1, 0.9, 1.1, 10.0, 300.0, 9999.0}) {
    CAPTURE(ratio);
    const State s = state_of(1, 0, 0.15, ratio * (1 + 1e-12) * 1e5, 1e5);
    const auto [A, B] = effective::static_force_field(s);
    const double root = std::sqrt(std::abs(B - A));
    const double angle = B > A ? std::asinh(root / std::sqrt(A)) : std::asin(root / std::sqrt(A));
    const double mean = s.law.stiffness_at_force(1) / 2 * (std::sqrt(B) + A / root * angle);
    // asin near 1 and the difference B - A spend three digits.
    CHECK(close(effective::uniform_strain(s).stiffness.bulk_modulus(), effective::prefactor(s) * mean / 9,
                1e-13));
  }
}

TEST_CASE("direction-dependent stiffness: homogeneous of degree 1/(1+alpha) in stress") {
  for_every_state([](const State& s) {
    State loaded = s;
    loaded.stress_v *= 37;
    loaded.stress_h *= 37;
    const double factor = std::pow(37, s.law.constant_exponent().value());
    const auto scaled = [&](elastic::TransverselyIsotropic c) {
      return elastic::TransverselyIsotropic{.C11 = factor * c.C11,
                                            .C33 = factor * c.C33,
                                            .C12 = factor * c.C12,
                                            .C13 = factor * c.C13,
                                            .C44 = factor * c.C44};
    };
    // Rounding only: forces, powers and sums.
    CHECK(difference(effective::uniform_strain(loaded).stiffness,
                     scaled(effective::uniform_strain(s).stiffness)) < 2e-14);
    CHECK(difference(effective::uniform_stress(loaded).stiffness,
                     scaled(effective::uniform_stress(s).stiffness)) < 2e-14);
  });
}

TEST_CASE("direction-dependent stiffness: scales of stress and length") {
  for (const double alpha : {1.0, 1.5, 2.0, infinity}) {
    const State s = state_of(alpha, 0.3, 0.15, 2e5, 1e5);
    State stiff = s;
    stiff.law = law_of(alpha, 0.15, 5e-4, 8 * 30e9);
    stiff.stress_v *= 8;
    stiff.stress_h *= 8;
    State large = s;
    large.law = law_of(alpha, 0.15, 1e-3);
    large.radius = 1e-3;
    for (const auto estimate : {effective::uniform_strain, effective::uniform_stress}) {
      const auto c = estimate(s).stiffness;
      const elastic::TransverselyIsotropic eightfold{
          .C11 = 8 * c.C11, .C33 = 8 * c.C33, .C12 = 8 * c.C12, .C13 = 8 * c.C13, .C44 = 8 * c.C44};
      CHECK(difference(estimate(stiff).stiffness, eightfold) < 1e-14); // powers enter: rounding only
      CHECK(difference(estimate(large).stiffness, c) < 1e-14);
    }
  }
}

TEST_CASE("direction-dependent stiffness: exchange of weak and strong axis") {
  // More stress along the axis stiffens along the axis, more contacts along it as well.
  const auto base = effective::uniform_strain(state_of(2, 0, 0.15, 1e5, 1e5)).stiffness;
  const auto loaded = effective::uniform_strain(state_of(2, 0, 0.15, 3e5, 1e5)).stiffness;
  const auto oriented = effective::uniform_strain(state_of(2, 0.5, 0.15, 1e5, 1e5)).stiffness;
  CHECK(loaded.C33 / base.C33 > loaded.C11 / base.C11);
  CHECK(oriented.C33 > base.C33);
  CHECK(oriented.C11 < base.C11);
}

TEST_CASE("direction-dependent stiffness: passes continuously into the closed form") {
  for (const double alpha : {1.0, 2.0, 7.0}) {
    const auto closed = state_of(alpha, 0, 0.15, 1e5, 1e5);
    const auto nearby = state_of(alpha, 0, 0.15, 1e5 * (1 + 1e-15), 1e5);
    CHECK(difference(effective::uniform_strain(nearby).stiffness,
                     effective::uniform_strain(closed).stiffness) < 1e-14);
    CHECK(difference(effective::uniform_stress(nearby).stiffness,
                     effective::uniform_stress(closed).stiffness) < 1e-14);
  }
}

TEST_CASE("direction-dependent stiffness: unloaded packings") {
  for (const double a : {-1.0, 0.0, 0.4}) {
    for (const double alpha : {1.0, 2.0, 341.0})
      for (const auto estimate : {effective::uniform_strain, effective::uniform_stress}) {
        const auto c = estimate(state_of(alpha, a, 0.15, 0, 0)).stiffness;
        CHECK(c.C11 == 0);
        CHECK(c.C33 == 0);
        CHECK(c.C12 == 0);
        CHECK(c.C13 == 0);
        CHECK(c.C44 == 0);
      }
    const auto flat = effective::uniform_strain(state_of(infinity, a, 0.15, 0, 0)).stiffness;
    CHECK(difference(flat, effective::uniform_strain(state_of(infinity, a, 0.15, 3e5, 1e5)).stiffness) == 0);
  }
}

TEST_CASE("direction-dependent stiffness: extremes stay finite and stable") {
  int unstable = 0;
  for (const double alpha : {1.0, 2.0, 1e6, infinity})
    for (const double a : {-1.2, -1.0, 1.0, 1.2})
      for (const double nu : {std::nextafter(-1.0, 0.0), 0.5})
        for (const double ratio : {1e-3, 1.0, 1e3})
          for (const double scale : {1e-250, 1e-3, 1e9})
            for (const auto estimate : {effective::uniform_strain, effective::uniform_stress}) {
              const auto [c, validity] = estimate(state_of(alpha, a, nu, ratio * scale, scale));
              REQUIRE(all_finite(c));
              const bool stable =
                  c.C44 > 0 && c.C66() > 0 && c.C33 > 0 && (c.C11 + c.C12) * c.C33 > 2 * c.C13 * c.C13;
              unstable += !stable;
              // |a| > 1 is not a density; what it spoils is said in a note of its own.
              CHECK((stable || (std::abs(a) > 1 && validity.notes.size() >= 2)));
            }
  CHECK(unstable > 0);
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
