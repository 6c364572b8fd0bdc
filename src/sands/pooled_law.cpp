// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/sands/pooled_law.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/core/units.hpp>
#include <granum/sands/known_sands.hpp>
#include <granum/sands/measured_sands.hpp>

#include "constants.hpp"

namespace granum::sands {

namespace {

// Range of the tests.
constexpr double low_stress_exponent = 0.50; ///< s below low_stress
constexpr double noted_above =
    2 * MPa; ///< up to here, and below least_tested_stress, the range widens without a note
constexpr double least_e = 0.40, largest_e = 0.93;
constexpr double gravel = 4.75 * mm, least_d50 = 0.06 * mm; ///< limits of sand

double largest(double a, double b, double c) { return std::max({a, b, c}); }

/// Distance of a number outside of [low, high], of logarithms or differences; 0 inside.
double beyond(double value, double low, double high) { return largest(low - value, value - high, 0); }

bool has_limits(const Sand& sand) { return sand.least_void_ratio && sand.largest_void_ratio; }

/// Whether e_min and e_max are like those of the sands tested: 0.37 to 0.80, 0.69 to 1.09, 0.24 to 0.47
/// apart.
bool limits_tested(const Sand& sand) {
  const double least = *sand.least_void_ratio, largest = *sand.largest_void_ratio;
  constexpr double near = 0.05; // of the ends of the tests
  return beyond(least, 0.37 - near, 0.80 + near) == 0 && beyond(largest, 0.69 - near, 1.09 + near) == 0 &&
         beyond(largest - least, 0.24 - near, 0.47 + near) == 0;
}

void require_valid(const Sand& sand, double void_ratio, double mean_stress) {
  require_positive("void_ratio", void_ratio);
  require_non_negative("mean_stress", mean_stress, "Pa");
  if (sand.uniformity)
    require_closed("uniformity", *sand.uniformity, 1, 1e3);
  if (sand.d50)
    require_positive("d50", *sand.d50, "m");
  require_positive("level_factor", sand.level_factor);
  require_finite("exponent_shift", sand.exponent_shift);
  require_finite("poisson_shift", sand.poisson_shift);
  if (sand.relative_density)
    require_finite("relative_density", *sand.relative_density);
  if (has_limits(sand))
    require_void_ratio_limits(*sand.least_void_ratio, *sand.largest_void_ratio);
}

/// G at 100 kPa [Pa].
double level(const Sand& sand, double e) {
  switch (form_of(sand)) {
  case PooledForm::own_tests:
    return sand.tests->level * std::pow(hardin_richart_factor(2.17, e), sand.tests->power);
  case PooledForm::density_and_limits:
    return 92.7 * MPa * std::pow(10, 0.294 * *relative_density_of(sand, e) - 0.287 * *sand.least_void_ratio);
  case PooledForm::grading:
    return 39.4 * MPa * hardin_richart_factor(2.97, e) * std::pow(*sand.uniformity, -0.252);
  case PooledForm::relative_density:
    return 69.2 * MPa * std::pow(10, 0.241 * *sand.relative_density);
  case PooledForm::void_ratio:
    break;
  }
  return 33.6 * MPa * hardin_richart_factor(2.97, e);
}

/// s from 50 kPa on.
double exponent(const Sand& sand) {
  const double known =
      sand.tests ? sand.tests->exponent : 0.40 * std::pow(sand.uniformity.value_or(uniform_sand), 0.18);
  return known + sand.exponent_shift;
}

} // namespace

Sand sand_of(const KnownSand& known) {
  return {.uniformity = known.uniformity,
          .d50 = known.d50,
          .least_void_ratio = known.least_void_ratio,
          .largest_void_ratio = known.largest_void_ratio,
          .tests = known.tests,
          .quartz = std::string_view(known.mineral) == "quartz"};
}

std::optional<double> relative_density_of(const Sand& sand, double void_ratio) {
  return has_limits(sand)
             ? (*sand.largest_void_ratio - void_ratio) / (*sand.largest_void_ratio - *sand.least_void_ratio)
             : sand.relative_density;
}

void require_density(const Sand& sand, double void_ratio) {
  constexpr double densest = 1.2, rounding = 1e-9, agreement = 0.02;
  // One limit alone: no sand is looser than e_max, or denser than e_min by a fifth of a usual distance.
  constexpr double below = 0.2 * (usual_largest_void_ratio - usual_least_void_ratio);
  if (!sand.least_void_ratio && sand.largest_void_ratio)
    require_closed("void_ratio", void_ratio, 0, *sand.largest_void_ratio + rounding);
  if (sand.least_void_ratio && !sand.largest_void_ratio)
    require_closed("void_ratio", void_ratio, *sand.least_void_ratio - below, 1e6);
  const std::optional<double> D_r = relative_density_of(sand, void_ratio);
  if (D_r && sand.relative_density)
    require_closed("relative_density", *sand.relative_density, *D_r - agreement, *D_r + agreement);
  if (!D_r || (*D_r >= -rounding && *D_r <= densest + rounding))
    return;
  if (!has_limits(sand))
    throw InvalidArgument("relative_density", *D_r, "", "[0, 1.2]");
  const double least = *sand.least_void_ratio, largest = *sand.largest_void_ratio;
  require_void_ratio_limits(least, largest);
  throw InvalidArgument("void_ratio", void_ratio, "",
                        detail::closed_range(largest - densest * (largest - least), largest, void_ratio) +
                            ", a relative density of 0 to 1.2 between e_min " + short_text(least) +
                            " and e_max " + short_text(largest));
}

PooledForm form_of(const Sand& sand) {
  if (sand.tests)
    return PooledForm::own_tests;
  if (has_limits(sand))
    return PooledForm::density_and_limits;
  if (sand.uniformity)
    return PooledForm::grading;
  return sand.relative_density ? PooledForm::relative_density : PooledForm::void_ratio;
}

std::string formula(const Sand& sand) {
  switch (form_of(sand)) {
  case PooledForm::own_tests:
    return pretty(sand.tests->level, Dimension::pressure) + " ((2.17-e)^2/(1+e))^" +
           short_text(sand.tests->power) + " (p'/p_a)^s, fitted to the tests of this sand";
  case PooledForm::density_and_limits:
    return "92.7 MPa 10^(0.294 D_r - 0.287 e_min) (p'/p_a)^s";
  case PooledForm::grading:
    return "39.4 MPa (2.97-e)^2/(1+e) C_u^-0.252 (p'/p_a)^s";
  case PooledForm::relative_density:
    return "69.2 MPa 10^(0.241 D_r) (p'/p_a)^s";
  case PooledForm::void_ratio:
    break;
  }
  return "33.6 MPa (2.97-e)^2/(1+e) (p'/p_a)^s";
}

GrowthExponent growth_exponent(const Sand& sand, double mean_stress) {
  return mean_stress < low_stress ? GrowthExponent{low_stress_exponent + sand.exponent_shift, 0.07}
                                  : GrowthExponent{exponent(sand), 0.05};
}

double growth_factor(const Sand& sand, double mean_stress) {
  const double to_low_stress = std::pow(std::max(mean_stress, low_stress) / reference_stress, exponent(sand));
  return mean_stress < low_stress
             ? to_low_stress * std::pow(mean_stress / low_stress, low_stress_exponent + sand.exponent_shift)
             : to_low_stress;
}

double forecast_variance(const Sand& sand, double from, double to) {
  const double low = std::min(from, to), high = std::max(from, to);
  const double above = high > low_stress ? std::log(high / std::max(low, low_stress)) : 0;
  const double below = low < low_stress ? std::log(std::min(high, low_stress) / low) : 0;
  const double by_s =
      growth_exponent(sand, low_stress).deviation * above + growth_exponent(sand, 0).deviation * below;
  return scatter_within_a_sand * scatter_within_a_sand + by_s * by_s;
}

double pooled_shear_modulus(const Sand& sand, double void_ratio, double mean_stress) {
  require_density(sand, void_ratio);
  return extrapolated_shear_modulus(sand, void_ratio, mean_stress);
}

double extrapolated_shear_modulus(const Sand& sand, double void_ratio, double mean_stress) {
  require_valid(sand, void_ratio, mean_stress);
  return sand.level_factor * level(sand, void_ratio) * growth_factor(sand, mean_stress);
}

double stated_factor(const Sand& sand, double void_ratio, double mean_stress) {
  constexpr double most = 1.6;
  const bool unusual = sand.uniformity.value_or(uniform_sand) > largest_tested_uniformity || !sand.quartz ||
                       sand.d50.value_or(mm) > gravel ||
                       (form_of(sand) == PooledForm::density_and_limits && !limits_tested(sand));
  if (unusual)
    return most;
  double within = 1.3;
  if (sand.tests)
    within = 1.15;
  else if (form_of(sand) == PooledForm::density_and_limits)
    within = 1.25;
  const double p = std::max(mean_stress, 1.0); // without stress the modulus is zero
  const double by_stress =
      0.3 * beyond(std::log(p), std::log(least_tested_stress), std::log(largest_tested_stress));
  const double limits_apart = has_limits(sand) ? *sand.largest_void_ratio - *sand.least_void_ratio
                                               : usual_largest_void_ratio - usual_least_void_ratio;
  const double beyond_limits = limits_apart * beyond(relative_density_of(sand, void_ratio).value_or(0), 0, 1);
  const double by_density = 3 * std::max(beyond_limits, beyond(void_ratio, least_e, largest_e));
  return std::min(most, std::exp(std::hypot(std::log(within), by_stress, by_density)));
}

std::string level_remark(double level) {
  constexpr double far = 2.5;
  const std::string times =
      "G is " + short_text(level, 2) + " times that of sands of this density and stress: ";
  if (level > far)
    return times + "more than possible without bonds; the ground is cemented, or a value has another unit or "
                   "is from another place";
  return level < 1 / far
             ? times + "a value has another unit, is from another place, or was measured at large strain"
             : std::string();
}

Validity outside_of_tests(const Sand& sand, double void_ratio, double mean_stress) {
  Validity notes;
  const auto note = [&](const char* what, double value, double low, double high, const char* unit) {
    if (value < low || value > high)
      notes.add(std::string(what) + " of " + short_text(value) + unit +
                " lies outside of the sands tested, " + short_text(low) + " to " + short_text(high) + unit);
  };
  note("a void ratio", void_ratio, least_e, largest_e, "");
  if (const double D_r = relative_density_of(sand, void_ratio).value_or(0); D_r > 1.005)
    notes.add("a relative density of " + percent_text(D_r) + " is beyond the densest state of its sand");
  if (has_limits(sand) && !limits_tested(sand))
    notes.add(
        "limits of the void ratio of " + short_text(*sand.least_void_ratio) + " and " +
        short_text(*sand.largest_void_ratio) +
        " lie outside of the sands tested, e_min 0.37 to 0.80 and e_max 0.69 to 1.09, 0.24 to 0.47 apart");
  if (mean_stress > noted_above)
    notes.add("a mean stress of " + pretty(mean_stress, Dimension::pressure) +
              " lies far outside of the sands tested, 25 to 500 kPa");
  if (sand.uniformity)
    note("a C_u", *sand.uniformity, 1, largest_tested_uniformity, "");
  if (sand.d50)
    note("a d50", *sand.d50 / mm, least_d50 / mm, gravel / mm, " mm");
  if (!sand.quartz)
    notes.add("the sands tested are of quartz; other grains scatter by a factor of 1.6");
  return notes;
}

PoissonRatio poisson_ratio(const Sand& sand, double mean_stress) {
  const double p = std::clamp(mean_stress, 10 * kPa, 10 * MPa);
  const bool graded = sand.uniformity.value_or(uniform_sand) > 3;
  const double nu = 0.20 - 0.05 * std::log10(p / reference_stress) + (graded ? 0.05 : 0);
  return {std::clamp(nu, 0.08, 0.35) + sand.poisson_shift, graded ? 0.08 : 0.06};
}

} // namespace granum::sands
