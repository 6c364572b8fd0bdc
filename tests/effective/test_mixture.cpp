// SPDX-License-Identifier: GPL-3.0-or-later
// Grains of several materials: the effective medium of their contacts, and what it does to the closed forms.
#include <granum/effective/mixture.hpp>

#include <numeric>

#include <granum/contact/grains.hpp>
#include <granum/effective/exponents.hpp>
#include <granum/effective/relaxation.hpp>
#include <granum/effective/rungs.hpp>

#include "effective/mixture_kernel.hpp"
#include "support.hpp"
#include "unit.hpp"

using namespace granum::test;
using effective::effective_stiffness;
using effective::mixed_contacts;
using effective::PairShare;
using effective::relaxed;

namespace {

constexpr contact::GrainMaterial soft{2e9, 0.2}, stiff{60e9, 0.3};

std::vector<PairShare> kinds_of(const std::vector<double>& shares, const std::vector<double>& stiffnesses) {
  std::vector<PairShare> kinds;
  for (std::size_t k = 0; k < shares.size(); ++k)
    kinds.push_back({.share = shares[k], .stiffness = stiffnesses[k]});
  return kinds;
}

/// Equal numbers of soft and stiff grains of shape alpha.
State mixed_state(double alpha) {
  State s = state_of(alpha, 0.1, 0.15, 1.2e5, 0.9e5);
  const auto mixed =
      mixed_contacts(std::array{soft, stiff}, std::array{0.5, 0.5}, *s.law.constant_exponent());
  s.law = s.law.of_grain(mixed.mean);
  s.pair_shares = mixed.pair_shares;
  return s;
}

} // namespace

TEST_CASE("mixture: the effective medium falls from the mean to the harmonic mean, and scales") {
  const std::vector<PairShare> kinds = kinds_of({0.2, 0.5, 0.3}, {0.01, 0.7, 300});
  double harmonic = 0, mean = 0;
  for (const PairShare& kind : kinds) {
    mean += kind.share * kind.stiffness;
    harmonic += kind.share / kind.stiffness;
  }
  CHECK(effective_stiffness(kinds, 0) == relative(mean, 1e-14));
  CHECK(effective_stiffness(kinds, 1) == relative(1 / harmonic, 1e-14));
  CHECK(effective_stiffness(kinds_of({0.5, 0.5}, {1, 10}), 1) == relative(20.0 / 11, 1e-14));
  double before = mean * (1 + 1e-15);
  for (double exchange = 0; exchange <= 1; exchange += 0.0625) {
    const double k = effective_stiffness(kinds, exchange);
    CHECK(k <= before);
    before = k;
    std::vector<PairShare> tenfold = kinds;
    for (PairShare& kind : tenfold)
      kind.stiffness *= 10;
    CHECK(effective_stiffness(tenfold, exchange) == relative(10 * k, 1e-13));
    const effective::kernel::Medium medium = effective::kernel::medium_of(kinds, exchange);
    if (const double h = 1e-5; exchange > 0 && exchange < 1)
      CHECK(medium.by_exchange ==
            relative((effective_stiffness(kinds, exchange + h) - effective_stiffness(kinds, exchange - h)) /
                         (2 * h),
                     1e-6));
  }
  CHECK(effective_stiffness(kinds_of({0.3, 0.7}, {2, 2}), 0.4) == 2);
  CHECK(effective_stiffness({}, 0.4) == 1);
  for (const double exchange : {-0.1, 1.1, double(NAN)})
    CHECK_THROWS_AS((void)effective_stiffness(kinds, exchange), InvalidArgument);
  for (const auto& bad : {kinds_of({0.5, 0.4}, {1, 2}), kinds_of({0.5, 0.5}, {0, 2}),
                          kinds_of({-0.5, 1.5}, {1, 2}), kinds_of({0.5, 0.5}, {1, NAN})})
    CHECK_THROWS_AS((void)effective_stiffness(bad, 0.5), InvalidArgument);
  // Roots found by bisection with 40 digits.
  CHECK(effective_stiffness(kinds_of({0.25, 0.5, 0.25}, {1, 1.577, 21.54}), 0.5) ==
        relative(2.359975376922500405, 1e-14));
  CHECK(effective_stiffness(kinds_of({0.25, 0.5, 0.25}, {1, 1.49, 4.64}), 0.65) ==
        relative(1.692490886439657799, 1e-14));
  CHECK(effective_stiffness(kinds_of({0.5, 0.5}, {1, 10}), 0.4953333) ==
        relative(3.184171121993154284, 1e-14));
}

TEST_CASE("mixture: kinds of contacts have the pair's stiffness, their mean is that of the law") {
  for (const double alpha : {1.0, 1.5, 2.0, infinity}) {
    const contact::NormalLaw law = law_of(alpha, 0.15);
    const double b = *law.constant_exponent(), force = 0.3;
    const auto mixed = mixed_contacts(std::array{soft, stiff}, std::array{0.3, 0.7}, b);
    REQUIRE(mixed.pair_shares.size() == 3);
    const std::array pairs{soft, contact::pair_material(soft, stiff), stiff};
    const std::array shares{0.09, 0.42, 0.49};
    const double of_mean = law.of_grain(mixed.mean).stiffness_at_force(force);
    double ratio = 0, mean = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK(mixed.pair_shares[k].share == relative(shares[k], 1e-13));
      CHECK(mixed.pair_shares[k].stiffness ==
            relative(law.of_grain(pairs[k]).stiffness_at_force(force) / of_mean, 1e-12));
      CHECK(mixed.pair_shares[k].force == 1);
      mean += shares[k] * mixed.pair_shares[k].stiffness;
      ratio += shares[k] * contact::mindlin_stiffness_ratio(pairs[k].poisson_ratio);
    }
    CHECK(mean == relative(1, 1e-13));
    CHECK(contact::mindlin_stiffness_ratio(mixed.mean.poisson_ratio) == relative(ratio, 1e-13));
  }
  const auto same = mixed_contacts(std::array{soft, soft}, std::array{0.3, 0.7}, 1.0 / 3);
  CHECK(same.pair_shares.empty());
  CHECK(same.mean == soft);
  const std::array pairs{effective::MaterialPair{.material = stiff, .weight = 2, .force = 3},
                         effective::MaterialPair{.material = soft, .weight = 6, .force = 1},
                         effective::MaterialPair{.material = stiff, .weight = 2, .force = 1}};
  const auto counted = mixed_contacts(pairs, 1.0 / 3); // mean force 1.4
  REQUIRE(counted.pair_shares.size() == 2);
  CHECK(counted.pair_shares[0].share == relative(0.6, 1e-14));
  CHECK(counted.pair_shares[0].force == relative(1 / 1.4, 1e-14));
  CHECK(counted.pair_shares[1].force == relative(2 / 1.4, 1e-14));

  for (const std::vector<double>& shares : {std::vector{0.3, 0.6}, {1.0}, {-0.1, 1.1}})
    CHECK_THROWS_AS((void)mixed_contacts(std::array{soft, stiff}, shares, 0.5), InvalidArgument);
  CHECK_THROWS_AS((void)mixed_contacts(std::array{soft, stiff}, std::array{0.5, 0.5}, 1), InvalidArgument);
  CHECK_THROWS_AS((void)mixed_contacts(std::span<const effective::MaterialPair>{}, 0.5), InvalidArgument);
}

TEST_CASE("mixture: rung 3 is that of the effective medium, rungs 0 to 2 that of the mean") {
  using namespace effective::kernel;
  for (const double alpha : {1.0, 2.0, infinity})
    for (const double z : {4.2, 5.0, 6.2, 9.0}) {
      const State mixed = mixed_state(alpha);
      State mean = mixed;
      mean.pair_shares.clear();
      const effective::RelaxedEstimate of_mixed = relaxed(mixed, z), of_mean = relaxed(mean, z);
      const double shear = effective_stiffness(mixed.pair_shares, shear_mixing.exchange * 4 / z),
                   bulk = effective_stiffness(mixed.pair_shares, bulk_mixing.exchange * 16 / (z * z));
      CHECK(of_mixed.stiffness.G_vh() / of_mean.stiffness.G_vh() == relative(shear, 1e-2)); // fabric couples
      CHECK(of_mixed.stiffness.bulk_modulus() / of_mean.stiffness.bulk_modulus() == relative(bulk, 1e-2));
      CHECK(of_mixed.relative_error.bulk_modulus ==
            relative(std::hypot(of_mean.relative_error.bulk_modulus, bulk_mixing.error * std::log(bulk)),
                     1e-12));
      CHECK(shear < 1);
      for (const effective::Rung& rung : effective::closed_forms()) {
        State packing = mixed, without = mean;
        packing.mechanical_coordination_number = without.mechanical_coordination_number = z;
        const double ratio = effective::answer(rung, packing).stiffness.G_vh() /
                             effective::answer(rung, without).stiffness.G_vh();
        if (rung.name == effective::RungName::uniform_stress)
          CHECK(ratio == relative(effective_stiffness(mixed.pair_shares, 1), 1e-12));
        else if (!rung.needs_coordination)
          CHECK(ratio == 1);
      }
      CHECK(of_mean.stiffness.G_vh() == relaxed(mean, z).stiffness.G_vh());
    }
  // Of unequal grains more is stated, and a note.
  State unequal = mixed_state(2), alone = unequal;
  unequal.contacts =
      alone.contacts = {.branch = 1.02, .branch_square = 1.08, .pair_radius = 0.98, .grain_volume = 1.1};
  alone.pair_shares.clear();
  const auto with = relaxed(unequal, 5), without = relaxed(alone, 5);
  const double stated = shear_mixing.size_error * std::sqrt(1.08 / (1.02 * 1.02) - 1);
  CHECK(with.relative_error.G_vh ==
        relative(
            std::hypot(without.relative_error.G_vh,
                       std::hypot(shear_mixing.error, stated) *
                           std::log(effective_stiffness(unequal.pair_shares, shear_mixing.exchange * 0.8))),
            1e-12));
  CHECK(with.validity.notes.size() == without.validity.notes.size() + 1);

  // Where the forces are known they are a lower bound of K: soft contacts have let others carry the load.
  State carried = mixed_state(2);
  const double before = relaxed(carried, 5).stiffness.bulk_modulus();
  double sum = 0;
  for (PairShare& kind : carried.pair_shares)
    sum += kind.share * kind.stiffness;
  for (PairShare& kind : carried.pair_shares)
    kind.force = kind.stiffness / sum; // all at one overlap: K of the mean
  State mean = carried;
  mean.pair_shares.clear();
  CHECK(relaxed(carried, 5).stiffness.bulk_modulus() > 1.2 * before);
  CHECK(relaxed(carried, 5).stiffness.bulk_modulus() ==
        relative(relaxed(mean, 5).stiffness.bulk_modulus(), 1e-2));

  State wrong = mixed_state(2);
  wrong.pair_shares[0].stiffness *= 1.1;
  CHECK_THROWS_AS((void)relaxed(wrong, 5), InvalidArgument);
  CHECK_THROWS_AS((void)effective::uniform_strain(wrong), InvalidArgument);
}

TEST_CASE("mixture: exponents include the exchange, which falls as contacts are gained") {
  const effective::Growth growth{
      .coordination_number = 0.05, .mechanical_coordination_number = 0.4, .void_ratio = -0.003};
  for (const double alpha : {1.0, 2.0})
    for (const double z : {4.6, 6.2}) {
      const State s = mixed_state(alpha);
      State mean = s;
      mean.pair_shares.clear();
      CHECK(effective::relaxed_exponents(s, z, growth, effective::Modulus::G_vh).sum() >
            effective::relaxed_exponents(mean, z, growth, effective::Modulus::G_vh).sum() + 0.005);
    }
}
