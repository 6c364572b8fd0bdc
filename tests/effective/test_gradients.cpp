// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/gradients.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include <doctest/doctest.h>
#include <granum/core/error.hpp>

#include "effective/support.hpp"

using namespace granum;
using namespace granum::test;
using effective::ContactForces;
using effective::Gradient;
using effective::Hypothesis;
using effective::Input;
using effective::Model;
using effective::Modulus;

namespace {

const std::vector<Modulus> all_moduli{Modulus::K,   Modulus::G_hh, Modulus::G_vh, Modulus::E_v, Modulus::E_h,
                                      Modulus::C11, Modulus::C33,  Modulus::C12,  Modulus::C13};
const std::vector<Model> all_models{{Hypothesis::uniform_strain, ContactForces::mean},
                                    {Hypothesis::uniform_strain, ContactForces::by_direction},
                                    {Hypothesis::free_spin, ContactForces::mean},
                                    {Hypothesis::free_spin, ContactForces::by_direction},
                                    {Hypothesis::uniform_stress, ContactForces::mean},
                                    {Hypothesis::uniform_stress, ContactForces::by_direction}};

/// A packing by the numbers that a user gives.
struct Numbers {
  double alpha, profile, shear, poisson, ratio, radius, voids, contacts, anisotropy, stress_v, stress_h;
};

State state_from(const Numbers& x) {
  return {.law = contact::PowerLaw::general({x.shear, x.poisson}, x.alpha, x.profile),
          .tangential_ratio = x.ratio,
          .radius = x.radius,
          .void_ratio = x.voids,
          .coordination_number = x.contacts,
          .fabric_anisotropy = x.anisotropy,
          .stress_v = x.stress_v,
          .stress_h = x.stress_h};
}

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

/// An input, by how much to move it for its size, and how it is moved.
struct Move {
  Input input;
  double size;
  std::function<void(Numbers&, double)> by;
};

std::vector<Move> moves(const Numbers& x) {
  const double p = (x.stress_v + 2 * x.stress_h) / 3;
  return {{Input::mean_stress, p,
           [p](Numbers& n, double d) {
             n.stress_v *= 1 + d / p;
             n.stress_h *= 1 + d / p;
           }},
          {Input::stress_v, x.stress_v, [](Numbers& n, double d) { n.stress_v += d; }},
          {Input::stress_h, x.stress_h, [](Numbers& n, double d) { n.stress_h += d; }},
          {Input::coordination_number, x.contacts, [](Numbers& n, double d) { n.contacts += d; }},
          {Input::void_ratio, x.voids, [](Numbers& n, double d) { n.voids += d; }},
          {Input::fabric_anisotropy, 1, [](Numbers& n, double d) { n.anisotropy += d; }},
          {Input::alpha, x.alpha, [](Numbers& n, double d) { n.alpha += d; }},
          {Input::grain_shear_modulus, x.shear, [](Numbers& n, double d) { n.shear += d; }},
          {Input::grain_poisson_ratio, 1, [](Numbers& n, double d) { n.poisson += d; }},
          {Input::grain_poisson_ratio_mindlin, 1,
           [](Numbers& n, double d) {
             n.poisson += d;
             n.ratio = contact::mindlin_stiffness_ratio(n.poisson);
           }},
          {Input::tangential_ratio, 1, [](Numbers& n, double d) { n.ratio += d; }},
          {Input::radius, x.radius, [](Numbers& n, double d) { n.radius += d; }}};
}

/// Central differences at three steps, extrapolated to an error of sixth order.
double difference_quotient(const Numbers& x, const Move& move, const Model& m, Modulus which) {
  const auto central = [&](double step) {
    Numbers low = x, high = x;
    move.by(low, -step);
    move.by(high, step);
    return (value_of(state_from(high), m, which) - value_of(state_from(low), m, which)) / (2 * step);
  };
  const double h = 4e-3 * move.size;
  const double d1 = central(h), d2 = central(h / 2), d4 = central(h / 4);
  const double fine = (4 * d4 - d2) / 3, coarse = (4 * d2 - d1) / 3;
  return (16 * fine - coarse) / 15;
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
            CHECK(close(g.value, value_of(state_from(x), m, which), 2e-13));
            for (const Move& move : moves(x)) {
              CAPTURE(int(move.input));
              CAPTURE(int(which));
              CAPTURE(int(m.hypothesis));
              CAPTURE(alpha);
              // Truncation ~ (4e-3)^6, rounding 1e-15 of the largest constant over the smallest step.
              const double C11 = value_of(state_from(x), m, Modulus::C11);
              const double error = std::abs(g[move.input] - difference_quotient(x, move, m, which)) *
                                   move.size / std::max(std::abs(g.value), C11);
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
            const double b = s.law.stiffness_exponent();
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
