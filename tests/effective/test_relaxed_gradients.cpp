// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <vector>

#include <doctest/doctest.h>
#include <granum/core/error.hpp>
#include <granum/effective/relaxation.hpp>
#include <granum/effective/relaxed_exponents.hpp>
#include <granum/effective/sensitivity/gradients.hpp>

#include "differences.hpp"
#include "relative.hpp"

using namespace granum;
using namespace granum::test;
using effective::Gradient;
using effective::Input;
using effective::Modulus;
using effective::relaxed_gradient;

namespace {

double relaxed_modulus(const State& s, double z, Modulus which) {
  return effective::modulus(effective::relaxed(s, z).stiffness, which);
}

/// Packings of the four families of contacts, at rest and unequally stressed.
std::vector<Numbers> packings(double z) {
  std::vector<Numbers> all;
  for (const double alpha : {1.0, 1.5, 2.0, 40.0})
    for (const double a : {0.0, 0.2})
      all.push_back({.alpha = alpha,
                     .profile = 0.4 * std::pow(5e-4, 1 - alpha),
                     .shear = 30e9,
                     .poisson = 0.15,
                     .ratio = contact::mindlin_stiffness_ratio(0.15),
                     .radius = 5e-4,
                     .voids = 0.558,
                     .contacts = 5.73,
                     .anisotropy = a,
                     .stress_v = a == 0 ? 1e5 : 1.7e5,
                     .stress_h = 1e5,
                     .z = z});
  return all;
}

/// The inputs of rungs 0 to 2 that these numbers can move by differences, and z*.
std::vector<Move> relaxed_moves(const Numbers& x) {
  std::vector<Move> all = moves(x);
  all.push_back({Input::mechanical_coordination_number, 1, [](Numbers& n, double d) { n.z += d; }});
  if (x.alpha == 1) // alpha < 1 is no contact law
    std::erase_if(all, [](const Move& move) { return move.input == Input::alpha; });
  return all;
}

} // namespace

TEST_CASE("relaxed gradients: of every modulus by every input, against central differences") {
  double worst = 0;
  for (const double z : {4.3, 5.2, 7.0})
    for (const Numbers& x : packings(z))
      for (const Modulus which : all_moduli) {
        const auto value = [&](const Numbers& n) { return relaxed_modulus(state_from(n), n.z, which); };
        const Gradient g = relaxed_gradient(state_from(x), z, which).gradient;
        CHECK(close(g.value, value(x), 1e-12));
        const double C11 = relaxed_modulus(state_from(x), z, Modulus::C11);
        for (const Move& move : relaxed_moves(x)) {
          CAPTURE(int(move.input));
          CAPTURE(int(which));
          CAPTURE(x.alpha);
          CAPTURE(z);
          // Truncation ~ (4e-3/0.34)^6/64, 0.34 the distance to the isostatic point, is far below rounding:
          // 1e-15 of the largest constant over the smallest step.
          const double error = std::abs(g[move.input] - difference_quotient(x, move, value)) * move.size /
                               std::max(std::abs(g.value), C11);
          worst = std::max(worst, error);
          CHECK(error < 1e-10);
        }
      }
  MESSAGE("largest error of a logarithmic derivative: ", worst);
}

TEST_CASE("relaxed gradients: the punch, whose alpha does not count") {
  for (const double a : {0.0, 0.2}) {
    const State s = state_of(infinity, a, 0.15, 1.5e5, 1e5);
    for (const Modulus which : all_moduli) {
      const Gradient g = relaxed_gradient(s, 5.2, which).gradient;
      CHECK(g[Input::alpha] == 0);
      const auto by = [&](double State::*member, double size) {
        const auto central = [&](double step) {
          State low = s, high = s;
          low.*member -= step;
          high.*member += step;
          return (relaxed_modulus(high, 5.2, which) - relaxed_modulus(low, 5.2, which)) / (2 * step);
        };
        const double step = 1e-3 * size;
        return (4 * central(step / 2) - central(step)) / 3;
      };
      // Truncation of fourth order, 1e-12/4 times derivatives of order one, over the smallest of them.
      const double C11 = relaxed_modulus(s, 5.2, Modulus::C11);
      CHECK(std::abs(g[Input::tangential_ratio] - by(&State::tangential_ratio, 1)) < 1e-9 * C11);
      CHECK(std::abs(g[Input::fabric_anisotropy] - by(&State::fabric_anisotropy, 1)) < 1e-9 * C11);
      CHECK(std::abs(g[Input::void_ratio] - by(&State::void_ratio, 1)) < 1e-9 * C11);
    }
  }
}

TEST_CASE("relaxed gradients: identities") {
  for (const double alpha : {1.0, 2.0, 341.0, infinity})
    for (const double a : {-0.3, 0.0, 0.3})
      for (const double stress_ratio : {0.5, 1.0, 2.0})
        for (const double z : {4.0, 6.0, 9.0})
          for (const Modulus which : all_moduli) {
            const State s = state_of(alpha, a, 0.15, stress_ratio * 1e5, 1e5);
            const Gradient g = relaxed_gradient(s, z, which).gradient;
            const double b = s.law.constant_exponent().value();
            // Sums of terms of either sign, amplified by the cancellation in C12 and C13.
            const auto same = [&](double x, double y) {
              return std::abs(x - y) <= 1e-12 * relaxed_modulus(s, z, Modulus::C11);
            };
            // z* and the stress ratio alone set the relaxation: scaling is that of uniform strain.
            const double p = (s.stress_v + 2 * s.stress_h) / 3;
            CHECK(same(p * g[Input::mean_stress], b * g.value));
            CHECK(same(s.stress_v * g[Input::stress_v] + s.stress_h * g[Input::stress_h], b * g.value));
            CHECK(same(30e9 * g[Input::grain_shear_modulus], (1 - b) * g.value));
            CHECK(same(s.coordination_number * g[Input::coordination_number], (1 - b) * g.value));
            CHECK(same((1 + s.void_ratio) * g[Input::void_ratio], -(1 - b) * g.value));
            CHECK(same(s.radius * g[Input::radius], (2 * b - 1) * g.value));
            const auto m = effective::relaxed_exponents(s, z, {}, which);
            CHECK(same(s.stress_v * g[Input::stress_v], m.stress_v * g.value));
            CHECK(same(s.stress_h * g[Input::stress_h], m.stress_h * g.value));
          }
}

TEST_CASE("relaxed gradients: a growing packing has the exponent of its growth along the path") {
  const State s = state_of(2, 0, 0.15, 1e5, 1e5);
  const effective::Growth growth{
      .coordination_number = 0.07, .mechanical_coordination_number = 0.31, .void_ratio = -0.004};
  const Gradient g = relaxed_gradient(s, 4.8, Modulus::G_vh).gradient;
  const double along = 1e5 * g[Input::mean_stress] +
                       growth.coordination_number * s.coordination_number * g[Input::coordination_number] +
                       growth.mechanical_coordination_number * g[Input::mechanical_coordination_number] +
                       growth.void_ratio * g[Input::void_ratio];
  CHECK(along / g.value ==
        relative(effective::relaxed_exponents(s, 4.8, growth, Modulus::G_vh).sum(), 1e-13));
}

TEST_CASE("relaxed gradients: of very many contacts those of uniform strain") {
  const State s = state_of(1.5, 0.2, 0.15, 2e5, 1e5);
  for (const Modulus which : all_moduli) {
    const Gradient with = relaxed_gradient(s, 1e7, which).gradient;
    const Gradient without = effective::gradient(s, {}, which);
    // What is left of relaxation falls as 1/z*.
    for (std::size_t i = 0; i < effective::input_count; ++i)
      CHECK(std::abs(with.by[i] - without.by[i]) <= 1e-5 * (std::abs(without.by[i]) + 0.1 * without.value));
    CHECK(without[Input::mechanical_coordination_number] == 0);
  }
}

TEST_CASE("relaxed gradients: the standard error is that of the estimate") {
  for (const double alpha : {1.0, 2.0, infinity})
    for (const double z : {4.0, 4.6, 6.0, 8.0})
      for (const double a : {0.0, 0.2})
        for (const double stress_v : {1e5, 1.8e5}) {
          const State s = state_of(alpha, a, 0.15, stress_v, 1e5);
          const auto estimate = effective::relaxed(s, z);
          const auto relative_error = [&](Modulus which) {
            const auto x = relaxed_gradient(s, z, which);
            return x.standard_error / x.gradient.value;
          };
          CHECK(relative_error(Modulus::G_vh) == relative(estimate.relative_error.G_vh, 1e-12));
          CHECK(relative_error(Modulus::G_hh) == relative(estimate.relative_error.G_hh, 1e-12));
          // An unequally stressed packing: K knows a little of the factor of G and of the stretch.
          const bool isotropic = a == 0 && stress_v == 1e5;
          CHECK(relative_error(Modulus::K) ==
                relative(estimate.relative_error.bulk_modulus, isotropic ? 1e-12 : 0.05));
        }
}

TEST_CASE("relaxed gradients: refused where nothing is rigid or loaded") {
  const State s = state_of(2, 0, 0.15, 1e5, 1e5);
  CHECK_THROWS_AS((void)relaxed_gradient(s, 3.5, Modulus::K), InvalidArgument);
  CHECK_THROWS_AS((void)relaxed_gradient(s, -1, Modulus::K), InvalidArgument);
  CHECK_THROWS_AS((void)relaxed_gradient(s, NAN, Modulus::K), InvalidArgument);
  CHECK_THROWS_AS((void)relaxed_gradient(state_of(2, 0, 0.15, 0, 0), 5, Modulus::K), InvalidArgument);
  State frictionless = s;
  frictionless.tangential_ratio = 0;
  CHECK_THROWS_AS((void)relaxed_gradient(frictionless, 6, Modulus::K), InvalidArgument);
  const auto g = relaxed_gradient(frictionless, 6.5, Modulus::G_vh);
  CHECK(g.gradient[Input::tangential_ratio] > 0);
  CHECK(std::isfinite(g.standard_error));
  State empty = s;
  empty.coordination_number = 0;
  CHECK_THROWS_AS((void)relaxed_gradient(empty, 5, Modulus::K), InvalidArgument);
  CHECK(effective::relaxed(empty, 5).stiffness.C44 == 0);
}
