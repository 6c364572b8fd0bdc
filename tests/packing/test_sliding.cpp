// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/packing/coordination.hpp>

#include "sample_packings.hpp"
#include "unit.hpp"

namespace {

/// Contacts with f_t/f_n evenly spaced below `limit`, and some that stand at it.
packing::Assembly sample(double limit, std::size_t below, std::size_t at_limit) {
  samples::Uniform uniform(3);
  packing::Assembly a{
      .cell = Mat3::identity(), .position = {{}, {0.5, 0, 0}}, .radius = {0.3, 0.3}, .contacts = {}};
  for (std::size_t k = 0; k < below + at_limit; ++k) {
    const double force = uniform(0.5, 1.5);
    const double place = (static_cast<double>(k) + 0.5) / static_cast<double>(below);
    const double ratio = k < below ? limit * place : limit;
    a.contacts.push_back({.i = 0,
                          .j = 1,
                          .branch = {0.5, 0, 0},
                          .overlap = 0.1,
                          .normal_force = force,
                          .tangential_force = {0, 0.6 * ratio * force, -0.8 * ratio * force}});
  }
  return a;
}

} // namespace

TEST_CASE("sliding: contacts that pile up at a ratio show the friction coefficient and their share") {
  packing::Assembly a = sample(0.4, 2000, 60);
  const auto friction = estimate_friction(a);
  REQUIRE(friction);
  CHECK(friction->coefficient == relative(0.4, 1e-4));
  CHECK(friction->contacts == 60);
  CHECK(sliding_fraction(a, 0.4) == relative(62.0 / 2060, 1e-14)); // 2 even ones lie within 1e-3 of the limit
  CHECK(sliding_fraction(a, 0.5) == 0);
  CHECK(sliding_fraction(a, 0) == 0);
  a.contacts[0].tangential_force = {0, 0.9 * a.contacts[0].normal_force, 0}; // as viscous forces make
  CHECK(estimate_friction(a).value().coefficient == relative(0.4, 1e-4));
}

TEST_CASE("sliding: ratios that only thin out, or contacts that hardly press, show no limit") {
  CHECK_FALSE(estimate_friction(sample(0.4, 2000, 0)));
  for (const std::size_t at_limit : {4U, 5U}) // from five on
    CHECK(estimate_friction(sample(0.4, 100, at_limit)).has_value() == (at_limit == 5));
  for (const std::size_t more : {0U, 175U, 185U}) // 20 in the last 1e-4, as everywhere: ten times as many
    CHECK(estimate_friction(sample(0.4, 200000, more)).has_value() == (more == 185));
  CHECK_FALSE(estimate_friction(
      packing::Assembly{.cell = Mat3::identity(), .position = {}, .radius = {}, .contacts = {}}));
  packing::Assembly frictionless = sample(0, 100, 10);
  CHECK_FALSE(estimate_friction(frictionless));

  packing::Assembly a = sample(0.4, 2000, 0);
  for (int k = 0; k < 50; ++k) {
    packing::Contact weak = a.contacts[0];
    weak.normal_force = 1e-5;
    weak.tangential_force = {0, 0.5e-5, 0};
    a.contacts.push_back(weak);
  }
  CHECK_FALSE(estimate_friction(a));
  CHECK(sliding_fraction(a, 0.45) == 0);
  CHECK_THROWS_AS((void)sliding_fraction(a, -0.1), InvalidArgument);
}
