// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/sensitivity/uncertainty.hpp>

#include <cmath>
#include <numeric>
#include <vector>

#include <doctest/doctest.h>
#include <granum/core/error.hpp>
#include <granum/effective/relaxation.hpp>

#include "relative.hpp"
#include "support.hpp"

using namespace granum;
using namespace granum::test;
using effective::Deviations;
using effective::Input;
using effective::Modulus;
using effective::relaxed_uncertainty;
using effective::uncertainty;
using effective::Uncertainty;

namespace {

constexpr effective::Sampling many{.draws = 20000, .seed = 7};
constexpr effective::Sampling some{.draws = 4000, .seed = 7};
constexpr effective::Sampling few{.draws = 400, .seed = 3};
/// Four standard errors of a standard deviation.
double error_of(const effective::Sampling& sampling) {
  return 4 / std::sqrt(2 * static_cast<double>(sampling.draws));
}

State packing() { return state_of(1.5, 0.1, 0.15, 1.4e5, 1e5); }

/// The inputs of a state that can be uncertain, each with one thousandth of its size.
std::vector<std::pair<Input, double>> small_deviations() {
  return {{Input::mean_stress, 130},
          {Input::stress_v, 140},
          {Input::stress_h, 100},
          {Input::coordination_number, 6e-3},
          {Input::void_ratio, 6e-4},
          {Input::fabric_anisotropy, 1e-3},
          {Input::alpha, 1.5e-3},
          {Input::grain_shear_modulus, 3e7},
          {Input::grain_poisson_ratio, 1e-3},
          {Input::grain_poisson_ratio_mindlin, 1e-3},
          {Input::tangential_ratio, 1e-3},
          {Input::radius, 5e-7},
          {Input::mechanical_coordination_number, 5e-3}};
}

double sum_of_squares(const effective::FirstOrder& first) {
  return std::inner_product(first.contributions.begin(), first.contributions.end(),
                            first.contributions.begin(), first.calibration * first.calibration);
}

/// A modulus that is linear in G_g: the flat punch's.
State linear_state() { return state_of(infinity, 0.2, 0.15, 1e5, 1e5); }

} // namespace

TEST_CASE("uncertainty: of a modulus that is linear in its input, first order is exact") {
  Deviations deviations;
  deviations[Input::grain_shear_modulus] = 6e9;
  const Uncertainty u = uncertainty(linear_state(), {}, Modulus::G_vh, deviations, many);
  // X = c G_g: the deviation is that of G_g, 6/30 of the modulus; 16 % and 84 % lie 0.9945 deviations off.
  CHECK(u.first_order.deviation == relative(0.2 * u.value, 1e-13));
  CHECK(u.sampled.deviation == relative(0.2 * u.value, error_of(many)));
  CHECK(std::abs(u.sampled.mean - u.value) < 4 * 0.2 * u.value / std::sqrt(20000.0));
  CHECK(std::abs(u.sampled.median - u.value) < 5 * 0.2 * u.value / std::sqrt(20000.0));
  CHECK(u.sampled.low == relative((1 - 0.2 * 0.99446) * u.value, 0.01));
  CHECK(u.sampled.high == relative((1 + 0.2 * 0.99446) * u.value, 0.01));
  CHECK(u.rejected == 0);
}

TEST_CASE("uncertainty: first order agrees with sampling where deviations are small, input by input") {
  for (const Modulus which : {Modulus::G_vh, Modulus::E_h})
    for (const auto& [input, deviation] : small_deviations()) {
      const int number = int(input);
      CAPTURE(number);
      CAPTURE(int(which));
      Deviations deviations;
      deviations[input] = deviation;
      for (const auto hypothesis : {effective::Hypothesis::uniform_strain, effective::Hypothesis::free_spin,
                                    effective::Hypothesis::uniform_stress})
        for (const auto forces : {effective::ContactForces::mean, effective::ContactForces::by_direction}) {
          const Uncertainty u = uncertainty(packing(), {hypothesis, forces}, which, deviations, few);
          // Four sampling errors; and where the slope vanishes, the curvature: some 1e-6 of the modulus.
          CHECK(std::abs(u.sampled.deviation - u.first_order.deviation) <
                error_of(few) * u.first_order.deviation + 1e-5 * u.value);
          CHECK(u.rejected == 0);
        }
    }
}

TEST_CASE("uncertainty: the same of relaxed moduli, whose calibration adds its error") {
  for (const Modulus which : {Modulus::K, Modulus::G_vh, Modulus::E_v}) {
    const Uncertainty exact = relaxed_uncertainty(packing(), 5.2, which, {}, some);
    const auto slopes = effective::relaxed_gradient(packing(), 5.2, which);
    CHECK(exact.value == slopes.gradient.value);
    CHECK(exact.first_order.deviation == slopes.standard_error);
    CHECK(exact.first_order.calibration == slopes.standard_error);
    CHECK(exact.sampled.deviation == relative(slopes.standard_error, error_of(some)));

    for (const auto& [input, deviation] : small_deviations()) {
      const int number = int(input);
      CAPTURE(number);
      CAPTURE(int(which));
      Deviations deviations;
      // As large as the calibration's own error, to be seen beside it, where that is still a small change.
      deviations[input] = input == Input::mechanical_coordination_number ? 0.05 : 20 * deviation;
      const Uncertainty u = relaxed_uncertainty(packing(), 5.2, which, deviations, some);
      CHECK(u.first_order.deviation >= slopes.standard_error);
      // Sampling, and the curvature over 2 % of an input.
      CHECK(u.sampled.deviation == relative(u.first_order.deviation, error_of(some) + 0.01));
    }
  }
}

TEST_CASE("uncertainty: contributions add up to the variance and do not know of each other") {
  Deviations all;
  for (const auto& [input, deviation] : small_deviations())
    all[input] = deviation;
  const Uncertainty u = relaxed_uncertainty(packing(), 5.2, Modulus::G_hh, all, {.draws = 100});
  CHECK(sum_of_squares(u.first_order) == relative(std::pow(u.first_order.deviation, 2), 1e-13));
  double shares = u.first_order.share(u.first_order.calibration);
  for (const double contribution : u.first_order.contributions)
    shares += u.first_order.share(contribution);
  CHECK(shares == relative(1, 1e-13));
  for (const auto& [input, deviation] : small_deviations()) {
    Deviations one;
    one[input] = deviation;
    const Uncertainty alone = relaxed_uncertainty(packing(), 5.2, Modulus::G_hh, one, {.draws = 100});
    const auto k = static_cast<std::size_t>(input);
    CHECK(alone.first_order.contributions[k] == u.first_order.contributions[k]);
    CHECK(alone.first_order.deviation ==
          relative(std::hypot(u.first_order.contributions[k], u.first_order.calibration), 1e-13));
  }
}

TEST_CASE("uncertainty: of Poisson's ratio takes k_t/k_n along or leaves it") {
  Deviations with_ratio, alone;
  with_ratio[Input::grain_poisson_ratio_mindlin] = 0.01;
  alone[Input::grain_poisson_ratio] = 0.01;
  const State s = state_of(2, 0, 0.15, 1e5, 1e5);
  const Uncertainty total = uncertainty(s, {}, Modulus::G_vh, with_ratio, many);
  const Uncertainty law = uncertainty(s, {}, Modulus::G_vh, alone, many);
  // G ~ (1-nu)^(-2/3) (2+3r), r = 2(1-nu)/(2-nu): dr/dnu = -2/(2-nu)^2 takes most of it back.
  const double r = s.tangential_ratio, by_law = 2.0 / 3 / 0.85;
  const double by_ratio = -3 * 2 / (1.85 * 1.85) / (2 + 3 * r);
  CHECK(law.first_order.deviation == relative(0.01 * by_law * law.value, 1e-12));
  CHECK(total.first_order.deviation == relative(0.01 * (by_law + by_ratio) * total.value, 1e-12));
  CHECK(total.sampled.deviation == relative(total.first_order.deviation, 0.04));
}

TEST_CASE("uncertainty: draws that no packing can have are counted and left out") {
  Deviations deviations;
  deviations[Input::void_ratio] = 0.558; // one deviation from zero: 15.9 % are negative
  const State s = state_of(2, 0, 0.15, 1e5, 1e5);
  const Uncertainty u = uncertainty(s, {}, Modulus::K, deviations, many);
  const double share = static_cast<double>(u.rejected) / many.draws;
  CHECK(std::abs(share - 0.158655) < 4 * std::sqrt(0.16 * 0.84 / many.draws));
  CHECK(u.sampled.median < u.value); // what is left is looser than the mean
  // Nothing is left where every draw is impossible.
  deviations[Input::void_ratio] = 0;
  deviations[Input::grain_poisson_ratio] = 1e12;
  CHECK_THROWS_AS((void)uncertainty(s, {}, Modulus::K, deviations, {.draws = 100}), InvalidArgument);
}

TEST_CASE(
    "uncertainty: first order breaks down near the isostatic point, where half of the packings are loose "
    "and none is softer than nothing") {
  Deviations deviations;
  deviations[Input::mechanical_coordination_number] = 0.4;
  const State s = state_of(2, 0, 0.15, 1e5, 1e5);
  const Uncertainty u = relaxed_uncertainty(s, 4.1, Modulus::G_vh, deviations, many);
  CHECK(u.first_order.deviation > u.value);
  CHECK(u.sampled.low == 0);
  CHECK(u.sampled.mean > u.value);
  const Uncertainty E = relaxed_uncertainty(s, 4.1, Modulus::E_v, deviations, some);
  CHECK(E.sampled.low == 0);
  CHECK(E.rejected == 0);
}

TEST_CASE("uncertainty: the same seed gives the same numbers, another one others") {
  Deviations deviations;
  deviations[Input::void_ratio] = 0.02;
  const auto median = [&](std::uint64_t seed) {
    return uncertainty(packing(), {}, Modulus::K, deviations, {.draws = 500, .seed = seed}).sampled.median;
  };
  CHECK(median(1) == median(1));
  CHECK(median(1) != median(2));
}

TEST_CASE("uncertainty: numbers that move several inputs") {
  // A rattler share x_0 of which z* = C_n/(1-x_0) and a C_n that both moduli know of.
  const State s = state_of(2, 0, 0.15, 1e5, 1e5);
  const double x0 = 0.05, z = s.coordination_number / (1 - x0);
  std::vector<effective::UncertainNumber> numbers(2);
  numbers[0] = {.value = s.coordination_number, .deviation = 0.02, .slopes = {}};
  numbers[0].slopes[std::size_t(Input::coordination_number)] = 1;
  numbers[0].slopes[std::size_t(Input::mechanical_coordination_number)] = 1 / (1 - x0);
  numbers[1] = {.value = x0, .deviation = 0.004, .slopes = {}};
  numbers[1].slopes[std::size_t(Input::mechanical_coordination_number)] = z / (1 - x0);
  const auto slopes = effective::relaxed_gradient(s, z, Modulus::G_vh);
  const auto first = effective::first_order(slopes.gradient, numbers);
  const auto evaluate = [&](std::span<const double> x) {
    State moved = s;
    moved.coordination_number = x[0];
    const double moved_z = effective::mechanical_coordination_number(x[0], x[1]);
    return std::vector{effective::relaxed(moved, moved_z).stiffness.C44, x[1]};
  };
  const auto sample = effective::sample(numbers, evaluate, some);
  CHECK(sample.bands[0].deviation == relative(first.deviation, error_of(some) + 0.003));
  CHECK(sample.bands[1].deviation == relative(0.004, error_of(some)));
  CHECK(first.calibration == 0);
}

TEST_CASE("uncertainty: what a number draws depends on its key, not on its place or its company") {
  const auto number = [](double value, const char* key) {
    return effective::UncertainNumber{.value = value, .deviation = 0.1, .slopes = {}, .key = key};
  };
  const effective::UncertainNumber e = number(0.6, "void-ratio"), C_n = number(5.7, "coordination-number"),
                                   p = number(3, "pressure");
  // What is drawn for each of them, in the order of the arguments.
  const auto drawn = [](const std::vector<effective::UncertainNumber>& numbers, std::uint64_t seed = 1) {
    std::vector<std::vector<double>> draws(numbers.size());
    (void)effective::sample(numbers,
                            [&](std::span<const double> x) {
                              for (std::size_t k = 0; k < x.size(); ++k)
                                draws[k].push_back(x[k]);
                              return std::vector{x[0]};
                            },
                            {.draws = 100, .seed = seed});
    return draws;
  };
  const auto both = drawn({e, C_n}), turned = drawn({C_n, e}), three = drawn({p, C_n, e});
  CHECK(both[0] == turned[1]);
  CHECK(both[1] == turned[0]);
  CHECK(three[1] == both[1]);
  CHECK(three[2] == both[0]);
  CHECK(drawn({e}, 2)[0] != both[0]);
  // Independent: no two streams are the same numbers.
  double products = 0;
  for (std::size_t k = 0; k < 100; ++k)
    products += (both[0][k] - 0.6) * (both[1][k] - 5.7) / 0.01;
  CHECK(std::abs(products / 100) < 0.4); // four standard errors
  CHECK_THROWS_AS((void)drawn({e, e}), InvalidArgument);
}

TEST_CASE("uncertainty: refuses what is no deviation") {
  Deviations deviations;
  deviations[Input::void_ratio] = -0.01;
  CHECK_THROWS_WITH_AS((void)uncertainty(packing(), {}, Modulus::K, deviations),
                       "deviation of void_ratio = -0.01 is outside [0, inf)", InvalidArgument);
  deviations[Input::void_ratio] = NAN;
  CHECK_THROWS_AS((void)uncertainty(packing(), {}, Modulus::K, deviations), InvalidArgument);
  deviations = {};
  deviations[Input::alpha] = 0.1;
  CHECK_THROWS_AS((void)uncertainty(linear_state(), {}, Modulus::K, deviations), InvalidArgument);
  CHECK_THROWS_AS((void)relaxed_uncertainty(packing(), 3.5, Modulus::K, {}), InvalidArgument);
  CHECK_THROWS_AS((void)uncertainty(packing(), {}, Modulus::K, {}, {.draws = 1}), InvalidArgument);
  CHECK_THROWS_AS((void)effective::first_order({}, {}, -1), InvalidArgument);
}
