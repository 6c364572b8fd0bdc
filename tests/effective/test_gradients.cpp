// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/sensitivity/gradients.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

#include <doctest/doctest.h>
#include <granum/core/error.hpp>

#include "differences.hpp"
#include "relative.hpp"

using namespace granum;
using namespace granum::test;
using effective::ContactForces;
using effective::Gradient;
using effective::Hypothesis;
using effective::Input;
using effective::Model;
using effective::Modulus;

namespace {

const std::vector<Model> all_models{{Hypothesis::uniform_strain, ContactForces::mean},
                                    {Hypothesis::uniform_strain, ContactForces::by_direction},
                                    {Hypothesis::free_spin, ContactForces::mean},
                                    {Hypothesis::free_spin, ContactForces::by_direction},
                                    {Hypothesis::uniform_stress, ContactForces::mean},
                                    {Hypothesis::uniform_stress, ContactForces::by_direction}};

double value_of(const State& s, const Model& m, Modulus which) {
  if (m.forces == ContactForces::mean) {
    const auto c = effective::uniform_contacts(s);
    return effective::modulus(
        m.hypothesis == Hypothesis::uniform_strain ? effective::uniform_strain_stiffness(c)
        : m.hypothesis == Hypothesis::free_spin    ? effective::free_spin_stiffness(c)
                                                   : effective::uniform_stress_stiffness(c),
        which);
  }
  return effective::modulus(m.hypothesis == Hypothesis::uniform_strain
                                ? effective::uniform_strain(s).stiffness
                            : m.hypothesis == Hypothesis::free_spin ? effective::free_spin(s).stiffness
                                                                    : effective::uniform_stress(s).stiffness,
                            which);
}

} // namespace

TEST_CASE("gradients: of every modulus by every input, against central differences") {
  double worst = 0;
  for (const double alpha : {1.2, 2.0, 60.0})
    for (const double a : {-0.6, 0.4})
      for (const double ratio : {0.4, 3.0}) {
        const double nu = 0.15;
        const Numbers x{alpha,
                        0.4 * std::pow(5e-4, 1 - alpha),
                        30e9,
                        nu,
                        contact::mindlin_stiffness_ratio(nu),
                        5e-4,
                        0.558,
                        5.73,
                        a,
                        ratio * 1e5,
                        1e5};
        for (const Model& m : all_models)
          for (const Modulus which : all_moduli) {
            const Gradient g = effective::gradient(state_from(x), m, which);
            const auto value = [&](const Numbers& n) { return value_of(state_from(n), m, which); };
            CHECK(close(g.value, value(x), 2e-13));
            for (const Move& move : moves(x)) {
              CAPTURE(int(move.input));
              CAPTURE(int(which));
              CAPTURE(int(m.hypothesis));
              CAPTURE(alpha);
              // Truncation ~ (4e-3)^6, rounding 1e-15 of the largest constant over the smallest step.
              const double C11 = value_of(state_from(x), m, Modulus::C11);
              const double error = std::abs(g[move.input] - difference_quotient(x, move, value)) * move.size /
                                   std::max(std::abs(g.value), C11);
              worst = std::max(worst, error);
              CHECK(error < 1e-10);
            }
          }
      }
  MESSAGE("largest error of a logarithmic derivative: ", worst);
}

TEST_CASE("gradients: identities") {
  for (const double alpha : {1.0, 2.0, 341.0, infinity})
    for (const double a : {-1.0, 0.0, 1.0})
      for (const double ratio : {0.1, 1.0, 10.0})
        for (const Model& m : all_models)
          for (const Modulus which : all_moduli) {
            const State s = state_of(alpha, a, 0.15, ratio * 1e5, 1e5);
            const Gradient g = effective::gradient(s, m, which);
            const double b = s.law.constant_exponent().value();
            const double p = (s.stress_v + 2 * s.stress_h) / 3;
            // Sums of a few terms of either sign: 1e-13 of the largest.
            const auto same = [&](double x, double y) {
              return std::abs(x - y) <= 1e-12 * std::abs(g.value);
            };
            CHECK(same(p * g[Input::mean_stress], b * g.value));
            CHECK(same(s.stress_v * g[Input::stress_v] + s.stress_h * g[Input::stress_h], b * g.value));
            CHECK(same(s.coordination_number * g[Input::coordination_number], (1 - b) * g.value));
            CHECK(same((1 + s.void_ratio) * g[Input::void_ratio], -(1 - b) * g.value));
            CHECK(same(s.radius * g[Input::radius], (2 * b - 1) * g.value));
            CHECK(same(30e9 * g[Input::grain_shear_modulus], (1 - b) * g.value));
            if (std::isinf(alpha)) {
              CHECK(g[Input::alpha] == 0);
              CHECK(g[Input::stress_v] == 0);
            }
          }
}

TEST_CASE("gradients: of a product") {
  const State s = state_of(2, 0.3, 0.15, 2e5, 1e5);
  const Gradient x = effective::gradient(s, {}, Modulus::G_vh), y = effective::gradient(s, {}, Modulus::K);
  const Gradient xy = x * y;
  CHECK(xy.value == x.value * y.value);
  // Both are of degree 1/3 in stress.
  CHECK(close(5e5 / 3 * 0.8 * xy[Input::mean_stress], 2.0 / 3 * xy.value, 1e-13));
  CHECK(close(xy[Input::void_ratio], x[Input::void_ratio] * y.value + x.value * y[Input::void_ratio], 1e-15));
}

TEST_CASE("gradients: along alpha they pass smoothly through the series of the digamma step") {
  const auto slope = [](double alpha) {
    const State s =
        state_from({alpha, 0.4 * std::pow(5e-4, 1 - alpha), 30e9, 0.15, 0.9, 5e-4, 0.558, 5.73, 0, 1e5, 1e5});
    return effective::gradient(s, {}, Modulus::K)[Input::alpha];
  };
  const double step = 1e-6; // the series takes over at alpha = 49
  CHECK(close(slope(49 + step), slope(49 - step), 1e-6));
  CHECK(close((slope(49 + step) + slope(49 - 3 * step)) / 2, slope(49 - step), 1e-11));
}

TEST_CASE("gradients: refused where a derivative does not exist") {
  State s = state_of(2, 0, 0.15, 0, 0);
  CHECK_THROWS_AS((void)effective::gradient(s, {}, Modulus::K), InvalidArgument);
  s = state_of(2, 0, 0.15, 1e5, 1e5);
  s.coordination_number = 0;
  CHECK_THROWS_AS((void)effective::gradient(s, {}, Modulus::K), InvalidArgument);
  s = state_of(2, 0, 0.15, 1e5, 1e5);
  s.tangential_ratio = 0;
  for (const Modulus which : {Modulus::E_v, Modulus::E_h})
    CHECK_THROWS_AS((void)effective::gradient(s, {.hypothesis = Hypothesis::uniform_stress}, which),
                    InvalidArgument);
  // The shear modulus itself vanishes there, but not its growth with k_t/k_n.
  const Gradient G = effective::gradient(s, {.hypothesis = Hypothesis::uniform_stress}, Modulus::G_vh);
  CHECK(G.value == 0);
  CHECK(G[Input::tangential_ratio] > 0);
  // Punches of a metre on grains of a nanometre, of a solid beyond any: infinite moduli.
  State huge = s;
  huge.law = contact::PowerLaw::flat({1e300, 0.15}, 1);
  huge.radius = 1e-9;
  CHECK_THROWS_AS((void)effective::gradient(huge, {}, Modulus::K), InvalidArgument);
  CHECK_THROWS_AS((void)effective::uniform_strain_exponents(huge, Modulus::K), InvalidArgument);
}

TEST_CASE("gradients: Young's moduli of grains as soft or as hard as numbers allow") {
  const State s = state_of(infinity, 0.2, 0.15, 1.5e5, 1e5);
  for (const Modulus which : {Modulus::E_v, Modulus::E_h})
    for (const int power : {-800, -600, 500, 800}) {
      State other = s;
      auto grain = s.law.grain();
      grain.shear_modulus = std::scalbn(grain.shear_modulus, power);
      other.law = contact::PowerLaw::flat(grain, 0.0114 * 5e-4);
      const auto first = effective::gradient(s, {}, which), then = effective::gradient(other, {}, which);
      CAPTURE(power);
      CHECK(then.value == relative(std::scalbn(first.value, power), 1e-14));
      CHECK(then[Input::fabric_anisotropy] ==
            relative(std::scalbn(first[Input::fabric_anisotropy], power), 1e-12));
    }
}
