// SPDX-License-Identifier: GPL-3.0-or-later
// Rung 3 where it is known how unevenly the contacts share the forces.
#include <granum/effective/relaxation.hpp>

#include <optional>
#include <tuple>

#include <granum/effective/uniform_field.hpp>

#include "effective/relaxation_coefficients.hpp"
#include "effective/unevenness_kernel.hpp"
#include "support.hpp"
#include "unit.hpp"

using namespace granum::test;
using effective::relaxation;
using effective::relaxed;

TEST_CASE("relaxed: known forces change G and K by the gain, fading out towards the isostatic point") {
  using namespace effective::kernel;
  for (const double alpha : {1.0, 1.5, 2.0, infinity})
    for (const double z : {4.1, 4.2, 4.3, 4.4, 5.2, 6.3})
      for (const double Q : {-0.2, -0.05, 0.0, 0.03}) {
        State s = state_of(alpha, 0, 0.15, 1e5, 1e5);
        const effective::RelaxedEstimate usual = relaxed(s, z);
        const double b = s.law.constant_exponent().value(), B = b * (1 - b),
                     left = 1 - relaxation(z, s.tangential_ratio, b).shear.value,
                     x = std::clamp((z - 4.2) / 0.2, 0.0, 1.0), share = x * x * (3 - 2 * x);
        s.unevenness = effective::Unevenness{.value = Q};
        const effective::RelaxedEstimate known = relaxed(s, z);
        const auto gain = [&](const UnevennessCoefficients<double>& c) {
          return std::exp(share * (c[0] * Q + c[2] * left + B * (c[3] + c[4] * (z - 5))));
        };
        CHECK(known.stiffness.G_vh() / usual.stiffness.G_vh() == relative(gain(shear_gain), 1e-12));
        CHECK(known.stiffness.bulk_modulus() / usual.stiffness.bulk_modulus() ==
              relative(gain(bulk_gain), 1e-12));
        if (share == 1) {
          CHECK(known.relative_error.G_vh < usual.relative_error.G_vh);
          CHECK(known.relative_error.bulk_modulus <= usual.relative_error.bulk_modulus);
        }
        s.unevenness->standard_error = 0.02;
        const double more = share * shear_gain[0] * 0.02;
        CHECK(relaxed(s, z).relative_error.G_vh ==
              relative(std::hypot(known.relative_error.G_vh, more), 1e-12));
      }
  // Far beyond the packings of the fit the gain stays what it is at their end: 0.6 % of G, and 1 % of K, by
  // which K would exceed that of uniform strain, so that all moduli are scaled down.
  for (const double z : {8.7, 12.0, 1e3, 1e12}) {
    State many = state_of(1, 0, 0.15, 1e5, 1e5);
    const double usual = relaxed(many, z).stiffness.G_vh();
    many.unevenness = effective::Unevenness{};
    CHECK(relaxed(many, z).stiffness.G_vh() == relative(usual, 0.017));
  }
  State s = state_of(2, 0, 0.15, 1e5, 1e5);
  for (const double Q : {-1.1, 1.1, double(NAN)}) {
    s.unevenness = effective::Unevenness{.value = Q};
    CHECK_THROWS_AS((void)relaxed(s, 5), InvalidArgument);
  }
  s.unevenness = effective::Unevenness{.value = 0, .standard_error = -1};
  CHECK_THROWS_AS((void)relaxed(s, 5), InvalidArgument);
}

TEST_CASE("dense unevenness: forces of a dense packing remember the pressure of preparation, and fade") {
  for (const double alpha : {1.0, 1.5, 2.0}) {
    State s = state_of(alpha, 0, 0.15, 1e5, 1e5);
    const double b = s.law.constant_exponent().value();
    const auto Q = [&](double before) { return effective::dense_unevenness(s, before); };
    CHECK(Q(1e5).value < Q(1e4).value); // freshly prepared ones are the most uneven
    CHECK(Q(1e4).value < Q(1e3).value);
    CHECK(Q(1e3).value < 0);
    // ... by the square of the overlap, which is that of 100 kPa times 10^(1-b)
    const double fresh = Q(1e5).value - Q(1e-30).value;
    CHECK(Q(1e4).value - Q(1e-30).value == relative(fresh * std::pow(10, -2 * (1 - b)), 1e-10));
    // The slope is that of the same contacts at more pressure.
    const double h = 1e-4, p = 1e5;
    const auto at = [&](double step) {
      State more = s;
      more.stress_v = more.stress_h = p * std::exp(step);
      return effective::dense_unevenness(more, 1e4).value;
    };
    CHECK(Q(1e4).by_pressure == relative((at(h) - at(-h)) / (2 * h), 1e-7));
    CHECK(Q(1e4).standard_error > 0);
    for (const double refused : {0.0, -1.0, 1.01e5, double(NAN)})
      CHECK_THROWS_AS((void)Q(refused), InvalidArgument);
    s.coordination_number = 0;
    CHECK_THROWS_AS((void)Q(1e4), InvalidArgument);
  }
  // Without the pressure it is that of packings well above it, with a wide error.
  const State packed = state_of(2, 0, 0.15, 1e5, 1e5);
  const effective::Unevenness unknown = effective::dense_unevenness(packed, std::nullopt);
  CHECK(unknown.value < effective::dense_unevenness(packed, 1e4).value);
  CHECK(unknown.value > effective::dense_unevenness(packed, 1e5).value);
  CHECK(unknown.standard_error > 3 * effective::dense_unevenness(packed, 1e4).standard_error);
  CHECK(unknown.by_pressure > 0);
  // A tenth of the scatter of the first forces is left, by the square of the overlap, give or take a quarter.
  const auto prepared_at = [&](double p) { return effective::dense_unevenness(packed, p); };
  const effective::Unevenness tenth = prepared_at(1e5 * std::pow(0.1, 0.75));
  CHECK(unknown.value == relative(tenth.value, 1e-12));
  CHECK(std::hypot(tenth.standard_error, 0.25 * (prepared_at(1e5).value - tenth.value) / 0.9) ==
        relative(unknown.standard_error, 1e-9));
  State between = packed; // half as much is known at 5.65, between 5.5 and 5.8
  between.mechanical_coordination_number = 5.65;
  const effective::Unevenness half = effective::dense_unevenness(between, 1e4);
  CHECK(half.by_pressure == relative(prepared_at(1e4).by_pressure / 2, 1e-9));
  CHECK(half.standard_error ==
        relative((effective::kernel::usual_unevenness_scatter + prepared_at(1e4).standard_error) / 2, 1e-9));
  // A packing of fewer contacts was not made without friction: from z* = 5.5 down nothing is known.
  State loose = packed;
  for (const double z : {4.5, 5.0, 5.5}) {
    loose.mechanical_coordination_number = z;
    const effective::RelaxedEstimate usual = relaxed(loose, z);
    State taken = loose;
    taken.unevenness = effective::dense_unevenness(loose, 1e4);
    CHECK(relaxed(taken, z).stiffness.G_vh() == relative(usual.stiffness.G_vh(), 1e-10));
    // What is known of the scatter then, and the scatter of the forces, are together that without them.
    CHECK(relaxed(taken, z).relative_error.G_vh == relative(usual.relative_error.G_vh, 0.04));
  }
  // Equal springs carry uneven forces without being softer.
  CHECK(effective::dense_unevenness(state_of(infinity, 0, 0.15, 1e5, 1e5), 1e4).value == 0);
}

TEST_CASE("dense unevenness: three dense specimens of granum's own, with seeds that no fit has seen") {
  // Q of their contacts at 100 kPa, prepared at 10 kPa: mean of 30 specimens of 500 grains each.
  for (const auto& [alpha, C_n, e, measured] :
       {std::tuple{1.0, 6.290, 0.5611, -0.0237}, std::tuple{2.0, 6.031, 0.5739, -0.0150}}) {
    State s = state_of(alpha, 0, 0.15, 1e5, 1e5);
    s.coordination_number = C_n;
    s.void_ratio = e;
    CHECK(std::abs(effective::dense_unevenness(s, 1e4).value - measured) < 0.003);
  }
}
