// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/sands/pooled_law.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/core/units.hpp>
#include <granum/sands/known_sands.hpp>

#include "constants.hpp"

namespace granum::sands {

namespace {

// Range of the tests.
constexpr double low_stress_exponent = 0.50; ///< s below low_stress
constexpr double noted_above =
    2 * MPa; ///< up to here, and below least_tested_stress, the range widens without a note
constexpr double largest_factor = 1.9; ///< of stated_factor: gravel, and far outside of the tests
/// Of the tested sands together: only its ranges are used.
constexpr SandTests all_tests{.void_ratio_low = 0.40,
                              .void_ratio_high = 0.93,
                              .stress_low = least_tested_stress,
                              .stress_high = largest_tested_stress};
constexpr double gravel = 4.75 * mm; ///< d50 from here on

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
  require_sand(sand);
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
    return 36.4 * MPa * hardin_richart_factor(2.97, e) *
           std::pow(std::min(*sand.uniformity, largest_tested_uniformity), -0.126);
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

void require_sand(const Sand& sand) {
  constexpr double widest = 20; // the laws hold C_u at 8; beyond, coarse grains float in fine ones
  if (const double C_u = sand.uniformity.value_or(1); !(C_u >= 1 && C_u <= widest))
    throw InvalidArgument("uniformity", C_u, "",
                          "[1, 20]: the laws are of sands to C_u = 8, and wider gradings were not tested");
  if (sand.d50 && !(*sand.d50 >= silt_size))
    throw InvalidArgument(
        "d50", *sand.d50, "m",
        "[6.3e-05, inf): finer ground is silt or clay, to which laws of sands do not apply");
  if (sand.fines && !(*sand.fines >= 0 && *sand.fines <= largest_fines))
    throw InvalidArgument("fines", *sand.fines, "",
                          "[0, 0.5]: with more than half finer than 0.063 mm the ground is silt or clay, to "
                          "which laws of sands do not apply");
}

void require_density(const Sand& sand, double void_ratio) {
  constexpr double densest = 1.2, rounding = 1e-9, agreement = 0.02;
  // One limit alone: no sand is looser than e_max, or denser than e_min by a fifth of a usual distance.
  const UsualLimits usual = usual_limits(sand.uniformity);
  const double below = 0.2 * (usual.largest - usual.least);
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
    return std::string("36.4 MPa (2.97-e)^2/(1+e) C_u^-0.126 (p'/p_a)^s") +
           (*sand.uniformity > largest_tested_uniformity ? ", with C_u = 8 in the first power" : "");
  case PooledForm::relative_density:
    return "69.2 MPa 10^(0.241 D_r) (p'/p_a)^s";
  case PooledForm::void_ratio:
    break;
  }
  return "33.6 MPa (2.97-e)^2/(1+e) (p'/p_a)^s";
}

GrowthExponent growth_exponent(const Sand& sand, double mean_stress) {
  return mean_stress < low_stress ? GrowthExponent{low_stress_exponent + sand.exponent_shift, 0.07}
                                  : GrowthExponent{exponent(sand), 0.045};
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

namespace {

/// Squared deviation of ln G because a stress or a void ratio lies outside of tests.
double by_extrapolation(double void_ratio, double mean_stress, const SandTests& tests) {
  const double p = std::max(mean_stress, 1.0); // without stress the modulus is zero
  const double by_stress = 0.3 * beyond(std::log(p), std::log(tests.stress_low), std::log(tests.stress_high));
  const double by_density = 3 * beyond(void_ratio, tests.void_ratio_low, tests.void_ratio_high);
  return by_stress * by_stress + by_density * by_density;
}

/// The same outside of e_min to e_max.
double by_limits(const Sand& sand, double void_ratio) {
  const UsualLimits usual = usual_limits(sand.uniformity);
  const double apart =
      has_limits(sand) ? *sand.largest_void_ratio - *sand.least_void_ratio : usual.largest - usual.least;
  const double by_density = 3 * apart * beyond(relative_density_of(sand, void_ratio).value_or(0), 0, 1);
  return by_density * by_density;
}

/// One standard deviation of a factor, widened by a variance.
double widened(double within, double variance) {
  return std::exp(std::hypot(std::log(within), std::sqrt(variance)));
}

/// The factor of a sand without tests of its own, within all tests.
double unnamed_factor(const Sand& sand, PooledForm form) {
  if (sand.uniformity.value_or(uniform_sand) >= largest_tested_uniformity || sand.d50.value_or(mm) > gravel)
    return largest_factor;
  const bool unusual = !sand.quartz || sand.fines.value_or(0) > clean_fines ||
                       (form == PooledForm::density_and_limits && !limits_tested(sand));
  const double clean = form == PooledForm::density_and_limits ? 1.35
                       : form == PooledForm::relative_density ? 1.45
                                                              : 1.4;
  return unusual ? 1.6 : clean;
}

} // namespace

double stated_factor(const Sand& sand, double void_ratio, double mean_stress) {
  Sand unnamed = sand;
  unnamed.tests.reset();
  const PooledForm form = form_of(unnamed);
  const double by_uniformity =
      form == PooledForm::grading ? 0.2 * std::log(*sand.uniformity / uniform_sand) : 0;
  const double outside =
      std::max(by_extrapolation(void_ratio, mean_stress, all_tests), by_limits(sand, void_ratio));
  const double of_sands = std::min(
      largest_factor, widened(unnamed_factor(unnamed, form), by_uniformity * by_uniformity + outside));
  if (!sand.tests)
    return of_sands;
  return std::min(of_sands, widened(1.15, by_extrapolation(void_ratio, mean_stress, *sand.tests)));
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
      notes.add(std::string(what) + " of " + short_text(value) + unit + " lies outside of the " +
                (sand.tests ? "tests of this sand, " : "sands tested, ") + short_text(low) + " to " +
                short_text(high) + unit);
  };
  const SandTests& tests = sand.tests ? *sand.tests : all_tests;
  note("a void ratio", void_ratio, tests.void_ratio_low, tests.void_ratio_high, "");
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
  if (sand.d50 && *sand.d50 > gravel)
    notes.add("a d50 of " + pretty(*sand.d50, Dimension::length) + " is gravel: beyond the sands tested");
  if (sand.fines.value_or(0) > clean_fines)
    notes.add(percent_text(*sand.fines) +
              " of fines (silt and clay, finer than 0.063 mm): the sands tested are "
              "clean; others scatter by a factor of 1.6");
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

UsualLimits usual_limits(const std::optional<double>& uniformity) {
  const double wider =
      std::log(std::clamp(uniformity.value_or(uniform_sand), 1.0, largest_tested_uniformity) / uniform_sand);
  return {.least = 0.601 - 0.164 * wider,
          .largest = 0.907 - 0.120 * wider,
          .deviation = uniformity ? 0.08 : 0.11};
}

} // namespace granum::sands
