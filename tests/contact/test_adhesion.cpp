// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/contact/adhesion.hpp>

#include <granum/contact/power_law.hpp>

#include "unit.hpp"

using contact::Adhesion;
using contact::AdhesionModel;
using contact::adhesive_contact_at_force;
using contact::adhesive_contact_at_overlap;
using contact::AdhesiveContact;

namespace {

constexpr contact::GrainMaterial soft_grain{5e6, 0.3};
constexpr double grain_radius = 0.5e-3; // of two equal spheres: R* is half of it
constexpr double pi = std::numbers::pi;
constexpr Adhesion adhesions[] = {{AdhesionModel::jkr, 0.05}, {AdhesionModel::dmt, 0.05}};
constexpr double reduced = grain_radius / 2,
                 modulus = soft_grain.shear_modulus / (1 - soft_grain.poisson_ratio);

AdhesiveContact at_overlap(const Adhesion& adhesion, double overlap) {
  return adhesive_contact_at_overlap(adhesion, soft_grain, grain_radius, overlap);
}

AdhesiveContact at_force(const Adhesion& adhesion, double force) {
  return adhesive_contact_at_force(adhesion, soft_grain, grain_radius, force);
}

} // namespace

TEST_CASE("without surface energy both models of adhesion are Hertz' contact") {
  const auto hertz = contact::PowerLaw::sphere(soft_grain, grain_radius);
  for (const AdhesionModel model : {AdhesionModel::jkr, AdhesionModel::dmt})
    for (const double overlap : {1e-9, 1e-7, 1e-5}) {
      const AdhesiveContact c = at_overlap({model, 0}, overlap);
      CHECK(c.force == relative(hertz.force(overlap), 1e-14));
      CHECK(c.stiffness == relative(hertz.stiffness_at_overlap(overlap), 1e-14));
      CHECK(c.hertz_stiffness == relative(c.stiffness, 1e-14));
      const AdhesiveContact again = at_force({model, 0}, c.force);
      CHECK(again.stiffness == relative(c.stiffness, 1e-14));
    }
}

TEST_CASE("the stiffness of an adhesive contact is the slope of its force over its overlap") {
  for (const Adhesion& adhesion : adhesions)
    for (const double overlap : {2e-7, 1e-6, 1e-5, 1e-4}) {
      const double h = 1e-5 * overlap;
      const auto force = [&](double d) { return at_overlap(adhesion, d).force; };
      const AdhesiveContact c = at_overlap(adhesion, overlap);
      CHECK(c.overlap == relative(overlap, 1e-11));
      CHECK(c.stiffness == relative((force(overlap + h) - force(overlap - h)) / (2 * h), 1e-8));
      // The same state, reached from its force.
      const AdhesiveContact by_force = at_force(adhesion, c.force);
      CHECK(by_force.overlap == relative(overlap, 1e-11));
      CHECK(by_force.stiffness == relative(c.stiffness, 1e-12));
    }
}

TEST_CASE(
    "a JKR contact without load has (9 pi gamma R*^2/E*)^(1/3) as radius and 3/5 of what Hertz' has there") {
  // a^3 = 9 pi gamma R*^2/E* at F = 0: q = s R*/a^(3/2) = 1/3, k_n = 2 E* a (1/2)/(5/6). [Johnson1971]
  const AdhesiveContact c = at_force(adhesions[0], 0);
  CHECK(c.radius == relative(std::cbrt(9 * pi * 0.05 * reduced * reduced / modulus), 1e-14));
  CHECK(c.stiffness == relative(0.6 * 2 * modulus * c.radius, 1e-13));
  CHECK(c.overlap == relative(c.radius * c.radius / (3 * reduced), 1e-13));
  CHECK(std::abs(c.force) <
        1e-15 * contact::PowerLaw::sphere(soft_grain, grain_radius).force(c.overlap) * 100);
}

TEST_CASE("at pull-off a JKR contact has no stiffness, and one of DMT no area") {
  CHECK(contact::pull_off_force(adhesions[0], grain_radius) == relative(3 * pi * 0.05 * reduced, 1e-14));
  CHECK(contact::pull_off_force(adhesions[1], grain_radius) == relative(4 * pi * 0.05 * reduced, 1e-14));
  for (const Adhesion& adhesion : adhesions)
    for (const double beyond : {1.0, 1.5}) {
      const double limit = contact::pull_off_force(adhesion, grain_radius);
      const AdhesiveContact c = at_force(adhesion, -beyond * limit);
      CHECK(c.force == relative(-limit, 1e-12));
      CHECK(std::abs(c.stiffness) <= 1e-6 * at_force(adhesion, limit).stiffness);
    }
  CHECK(at_force(adhesions[1], -1).radius == 0);
}

TEST_CASE("a neck of the JKR theory reaches to its least overlap, softening below 0, and then breaks") {
  const double least = -0.75 * std::cbrt(4 * pi * pi * 0.05 * 0.05 * reduced / (modulus * modulus));
  const AdhesiveContact neck = at_overlap(adhesions[0], 0.99 * least);
  CHECK(neck.stiffness < 0);
  // 5/9 of the pull-off force where it breaks. [Johnson1971]
  CHECK(at_overlap(adhesions[0], (1 - 1e-12) * least).force ==
        relative(-5 / 9. * contact::pull_off_force(adhesions[0], grain_radius), 1e-5));
  CHECK(at_overlap(adhesions[0], 1.01 * least).stiffness == 0);
  CHECK(at_overlap(adhesions[0], 1.01 * least).force == 0);
  CHECK(at_overlap(adhesions[1], -1e-12).force == 0);
}

TEST_CASE("an adhesive contact of impossible numbers is refused") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double energy : {-0.1, nan, std::numeric_limits<double>::infinity()}) {
    const Adhesion bad{AdhesionModel::jkr, energy};
    CHECK_THROWS_AS((void)at_force(bad, 0), InvalidArgument);
    CHECK_THROWS_AS((void)contact::pull_off_force(bad, grain_radius), InvalidArgument);
  }
  CHECK_THROWS_AS((void)adhesive_contact_at_overlap(adhesions[0], {-1, 0.3}, grain_radius, 0),
                  InvalidArgument);
  CHECK_THROWS_AS((void)adhesive_contact_at_overlap(adhesions[0], soft_grain, 0, 0), InvalidArgument);
  CHECK_THROWS_AS((void)at_force(adhesions[0], nan), InvalidArgument);
}
