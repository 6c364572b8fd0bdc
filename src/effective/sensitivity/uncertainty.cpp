// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/sensitivity/uncertainty.hpp>

#include <cmath>
#include <numeric>
#include <string>

#include <granum/core/check.hpp>
#include <granum/core/error.hpp>
#include <granum/effective/relaxation.hpp>

#include "effective/kernels.hpp"

namespace granum::effective {

namespace {

constexpr const char* input_names[input_count] = {"mean_stress",
                                                  "stress_v",
                                                  "stress_h",
                                                  "coordination_number",
                                                  "void_ratio",
                                                  "fabric_anisotropy",
                                                  "alpha",
                                                  "grain_shear_modulus",
                                                  "grain_poisson_ratio",
                                                  "grain_poisson_ratio_mindlin",
                                                  "tangential_ratio",
                                                  "radius",
                                                  "mechanical_coordination_number"};

constexpr std::size_t index(Input input) { return static_cast<std::size_t>(input); }

const contact::PowerLaw& power_law(const State& s) {
  return kernel::power_law_of(s, "the uncertainty by every input");
}

/// One uncertain number for each input: its value, its deviation, and that no other input moves with it.
std::vector<UncertainNumber> numbers_of(const State& s, double z, const Deviations& deviations) {
  const auto& grain = s.law.grain();
  const double values[input_count] = {(s.stress_v + 2 * s.stress_h) / 3,
                                      s.stress_v,
                                      s.stress_h,
                                      s.coordination_number,
                                      s.void_ratio,
                                      s.fabric_anisotropy,
                                      power_law(s).alpha(),
                                      grain.shear_modulus,
                                      grain.poisson_ratio,
                                      grain.poisson_ratio,
                                      s.tangential_ratio,
                                      s.radius,
                                      z};
  std::vector<UncertainNumber> numbers(input_count);
  for (std::size_t i = 0; i < input_count; ++i) {
    require_non_negative(std::string("deviation of ") + input_names[i], deviations.by[i]);
    numbers[i] = {.value = values[i], .deviation = deviations.by[i], .slopes = {}, .key = input_names[i]};
    numbers[i].slopes[i] = 1;
  }
  if (std::isinf(power_law(s).alpha()) && deviations[Input::alpha] > 0)
    throw InvalidArgument("alpha of a flat punch is infinite and cannot be uncertain");
  return numbers;
}

/// The state that the values of the inputs, in their order, make of this one.
State moved(const State& s, std::span<const double> x) {
  const auto at = [&x](Input input) { return x[index(input)]; };
  const double nu = s.law.grain().poisson_ratio;
  const double mindlin_nu = at(Input::grain_poisson_ratio_mindlin);
  const contact::GrainMaterial grain{.shear_modulus = at(Input::grain_shear_modulus),
                                     .poisson_ratio = at(Input::grain_poisson_ratio) + (mindlin_nu - nu)};
  const double scale = at(Input::mean_stress) / ((s.stress_v + 2 * s.stress_h) / 3);
  const double growth = contact::mindlin_stiffness_ratio(mindlin_nu) - contact::mindlin_stiffness_ratio(nu);
  const double alpha = at(Input::alpha);
  const contact::PowerLaw& law = power_law(s);
  return {.law = alpha == law.alpha() ? law.of_grain(grain)
                                      : contact::PowerLaw::general(grain, alpha, law.profile_constant()),
          .tangential_ratio = at(Input::tangential_ratio) + growth,
          .radius = at(Input::radius),
          .void_ratio = at(Input::void_ratio),
          .coordination_number = at(Input::coordination_number),
          .fabric_anisotropy = at(Input::fabric_anisotropy),
          .stress_v = scale * at(Input::stress_v),
          .stress_h = scale * at(Input::stress_h),
          .contacts = s.contacts};
}

Uncertainty joined(double value, FirstOrder first, const Sample& sample) {
  return {.value = value,
          .first_order = std::move(first),
          .sampled = sample.bands.front(),
          .rejected = sample.rejected};
}

} // namespace

FirstOrder first_order(const Gradient& gradient, std::span<const UncertainNumber> numbers,
                       double standard_error) {
  FirstOrder result;
  result.calibration = require_non_negative("standard_error", standard_error, "Pa");
  result.deviation = result.calibration;
  for (const UncertainNumber& number : numbers) {
    require_non_negative("deviation", number.deviation);
    const double slope =
        std::inner_product(gradient.by.begin(), gradient.by.end(), number.slopes.begin(), 0.0);
    result.contributions.push_back(slope * number.deviation);
    result.deviation = std::hypot(result.deviation, slope * number.deviation);
  }
  return result;
}

Uncertainty uncertainty(const State& state, const Model& model, Modulus which, const Deviations& deviations,
                        const Sampling& sampling) {
  const Gradient slopes = gradient(state, model, which);
  const std::vector<UncertainNumber> numbers = numbers_of(state, 0, deviations);
  const auto evaluate = [&](std::span<const double> x) {
    return std::vector{modulus(uniform_field(moved(state, x), model).stiffness, which)};
  };
  return joined(slopes.value, first_order(slopes, numbers), sample(numbers, evaluate, sampling));
}

Uncertainty relaxed_uncertainty(const State& state, double mechanical_coordination_number, Modulus which,
                                const Deviations& deviations, const Sampling& sampling) {
  const auto [slopes, standard_error] = relaxed_gradient(state, mechanical_coordination_number, which);
  const std::vector<UncertainNumber> numbers = numbers_of(state, mechanical_coordination_number, deviations);
  const double relative_error = standard_error / slopes.value;
  std::vector<UncertainNumber> drawn = numbers;
  drawn.push_back({.value = 1, .deviation = relative_error, .slopes = {}, .key = "calibration"});
  const auto evaluate = [&](std::span<const double> x) {
    const auto c = relaxed(moved(state, x), x[index(Input::mechanical_coordination_number)]).stiffness;
    return std::vector{c.C44 > 0 ? x.back() * modulus(c, which) : 0};
  };
  return joined(slopes.value, first_order(slopes, numbers, standard_error),
                sample(drawn, evaluate, sampling));
}

} // namespace granum::effective
