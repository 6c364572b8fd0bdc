// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/contact_prior.hpp>

#include <granum/effective/uniform_field.hpp>

#include "support.hpp"
#include "unit.hpp"

using namespace granum::test;
using effective::Explained;
using effective::implied_coordination;
using effective::Modulus;

namespace {

constexpr Modulus measurable[] = {Modulus::K, Modulus::G_hh, Modulus::G_vh, Modulus::C11, Modulus::C33};

double modulus_with(const State& state, double z, Modulus which) {
  return modulus(
      relaxed(effective::with_contacts(state, z, effective::expected_rattlers(state, z).fraction), z)
          .stiffness,
      which);
}

} // namespace

TEST_CASE("implied coordination: the z* that a modulus was computed with") {
  for (const double alpha : {1.0, 2.0, 4.0, infinity})
    for (const double fabric : {0.0, 0.15})
      for (const double z : {4.05, 4.4, 5.0, 5.7, 6.3, 8.0, 11.0})
        for (const Modulus which : measurable) {
          const State state = state_of(alpha, fabric, 0.15, 100e3, 60e3);
          const auto implied = implied_coordination(state, which, modulus_with(state, z, which));
          REQUIRE(implied.mechanical_coordination_number);
          CHECK(*implied.mechanical_coordination_number == relative(z, 1e-10));
        }
}

TEST_CASE("implied coordination: moduli that no coordination number explains") {
  const State state = state_of(2, 0, 0.15, 100e3, 100e3);
  const double most = modulus_with(state, 12, Modulus::G_vh);
  const auto stiff = implied_coordination(state, Modulus::G_vh, 1.001 * most);
  CHECK(stiff.explained == Explained::too_stiff);
  CHECK_FALSE(stiff.mechanical_coordination_number);
  CHECK(stiff.stiffest == relative(most, 1e-12));
  // That is below uniform strain with as many contacts.
  const double bound = uniform_strain(effective::with_contacts(state, 12, 0)).stiffness.G_vh();
  CHECK(stiff.stiffest < bound);
  CHECK(implied_coordination(state, Modulus::G_vh, bound).explained == Explained::too_stiff);

  // K has a jump at the isostatic point, G begins at 0.
  const double least = modulus_with(
      state, effective::isostatic_coordination_number(state.tangential_ratio) + 1e-3, Modulus::K);
  const auto soft = implied_coordination(state, Modulus::K, 0.9 * least);
  CHECK(soft.explained == Explained::too_soft);
  CHECK_FALSE(soft.mechanical_coordination_number);
  CHECK(soft.softest == relative(least, 1e-2));
  CHECK(implied_coordination(state, Modulus::G_vh, 1e6).explained == Explained::yes);
  CHECK(implied_coordination(state, Modulus::G_vh, 1e6).softest < 1);
  // Rattlers take contacts away.
  const double measured = modulus_with(state, 5, Modulus::G_vh);
  const auto none = implied_coordination(state, Modulus::G_vh, measured, 0.0);
  const auto many = implied_coordination(state, Modulus::G_vh, measured, 0.2);
  CHECK(*none.mechanical_coordination_number < 5);
  CHECK(*many.mechanical_coordination_number > 5);
}

TEST_CASE("expected rattlers: those of the contact prior at its own z*") {
  for (const double void_ratio : {0.6, 0.66, 0.72})
    for (const double pressure : {10e3, 1e6}) {
      State state = state_of(2, 0, 0.15, pressure, pressure);
      state.void_ratio = void_ratio;
      const effective::ContactPrior prior = effective::contact_prior(state);
      const effective::ContactCounts& counts = prior.densest;
      const auto expected = expected_rattlers(state, counts.mechanical_coordination_number);
      CHECK(expected.fraction == relative(counts.rattler_fraction, 1e-9));
      CHECK(expected.scatter == prior.rattler_error);
    }
  const State state = state_of(2, 0, 0.15, 100e3, 100e3);
  CHECK(effective::expected_rattlers(state, 6).fraction < effective::expected_rattlers(state, 4.5).fraction);
}

TEST_CASE("implied coordination: refuses inputs without an answer") {
  const State state = state_of(2, 0, 0.15, 100e3, 100e3);
  for (const auto& [which, modulus] : {std::pair{Modulus::C12, 1e8}, std::pair{Modulus::E_v, 1e8},
                                       std::pair{Modulus::K, 0.0}, std::pair{Modulus::K, double(NAN)}})
    CHECK_THROWS_AS((void)implied_coordination(state, which, modulus), InvalidArgument);
  CHECK_THROWS_AS((void)implied_coordination(state_of(2, 0, 0.15, 0, 0), Modulus::K, 1e8), InvalidArgument);
  CHECK_THROWS_AS((void)effective::with_contacts(state, 5, 1), InvalidArgument);
  CHECK_THROWS_AS((void)effective::with_contacts(state, -1, 0), InvalidArgument);
}
