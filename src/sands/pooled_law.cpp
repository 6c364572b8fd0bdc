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

namespace {

double in_per_cent(const StrainedSand& s) { return 100 * s.strain; }
double in_atmospheres(const StrainedSand& s) { return s.mean_stress / standard_atmosphere; }
double uniformity(const StrainedSand& s) { return s.sand.uniformity.value_or(uniform_sand); }

/// 1/(1 + (strain/at_half)^a)^b, strains in per cent.
double hyperbola(double strain, double at_half, double a, double b = 1) {
  return std::pow(1 + std::pow(strain / at_half, a), -b);
}

double wang_stokoe_plain(const StrainedSand& s) {
  return hyperbola(in_per_cent(s), 0.068 * std::pow(in_atmospheres(s), 0.4), 0.729, 0.985);
}

double wang_stokoe_ratio_e(const StrainedSand& s) {
  const double at_half = 0.13 * std::pow(s.void_ratio, 0.545) - 0.043;
  return hyperbola(in_per_cent(s), std::max(at_half, 1e-3) * std::pow(in_atmospheres(s), 0.45), 0.804, 0.882);
}

double wang_stokoe_ratio_e_C_u(const StrainedSand& s) {
  const double at_half = 0.05 * std::pow(s.void_ratio, 0.1 * uniformity(s)) + 0.011;
  return hyperbola(in_per_cent(s), at_half * std::pow(in_atmospheres(s), 0.45), 0.834, 0.839);
}

double darendeli(const StrainedSand& s) {
  return hyperbola(in_per_cent(s), 0.0352 * std::pow(in_atmospheres(s), 0.3483), 0.919);
}

double menq_ratio(const StrainedSand& s) {
  const double C_u = uniformity(s), p = in_atmospheres(s);
  const double a = std::max(0.86 + 0.1 * std::log10(p), 0.1);
  return hyperbola(in_per_cent(s), 0.12 * std::pow(C_u, -0.6) * std::pow(p, 0.5 * std::pow(C_u, -0.15)), a);
}

double ishibashi_zhang(const StrainedSand& s) {
  const auto part = [&](double strain, double power) {
    return std::tanh(std::log(std::pow(strain / s.strain, power)));
  };
  const double K = 0.5 * (1 + part(0.000102, 0.492)), m = 0.272 * (1 - part(0.000556, 0.4));
  return std::min(1.0, K * std::pow(s.mean_stress / 1e3, m));
}

constexpr std::array<StrainLaw, 6> strain_table{{
    {"wang-stokoe-e-C_u", "WangStokoe2022",
     "1/(1+(g/g_r)^0.834)^0.839, g_r = (0.05 e^(0.1 C_u)+0.011) % (p/atm)^0.45", wang_stokoe_ratio_e_C_u},
    {"wang-stokoe-e", "WangStokoe2022",
     "1/(1+(g/g_r)^0.804)^0.882, g_r = (0.13 e^0.545-0.043) % (p/atm)^0.45", wang_stokoe_ratio_e},
    {"wang-stokoe", "WangStokoe2022", "1/(1+(g/g_r)^0.729)^0.985, g_r = 0.068 % (p/atm)^0.4",
     wang_stokoe_plain},
    {"darendeli", "Darendeli2001", "1/(1+(g/g_r)^0.919), g_r = 0.0352 % (p/atm)^0.3483", darendeli},
    {"menq", "Menq2003",
     "1/(1+(g/g_r)^a), a = 0.86+0.1 log10(p/atm), g_r = 0.12 % C_u^-0.6 (p/atm)^(0.5 C_u^-0.15)", menq_ratio},
    {"ishibashi-zhang", "IshibashiZhang1993",
     "K p^m, p in kPa, K = 0.5(1+tanh ln((0.000102/g)^0.492)), m = 0.272(1-tanh ln((0.000556/g)^0.4))",
     ishibashi_zhang},
}};

/// Standard deviation of ln(G/G0) between the laws.
double spread(const StrainedSand& s) {
  double sum = 0, squares = 0;
  for (const StrainLaw& law : strain_table) {
    const double y = std::log(law.ratio(s));
    sum += y;
    squares += y * y;
  }
  const auto n = static_cast<double>(strain_table.size());
  return std::sqrt(std::max(0.0, (squares - sum * sum / n) / (n - 1)));
}

} // namespace

std::span<const StrainLaw> strain_laws() { return strain_table; }

double damping_ratio(double r) { return std::max(0.0, 0.333 * (0.586 * r * r - 1.547 * r + 1)); }

StrainAnswer strained(const StrainedSand& s) {
  require_open("strain", s.strain, 0, 0.05 * (1 + 1e-12));
  require_positive("mean_stress", s.mean_stress, "Pa");
  (void)extrapolated_shear_modulus(s.sand, s.void_ratio, s.mean_stress); // refuses impossible values
  StrainAnswer out{.ratio = s.sand.uniformity ? wang_stokoe_ratio_e_C_u(s) : wang_stokoe_ratio_e(s),
                   .validity = {}};
  const double r = out.ratio, usual = std::log(1.13);
  out.log_deviation = std::min(std::max(usual, spread(s)), -std::log(r));
  out.damping = damping_ratio(r);
  if (s.strain > 5e-3)
    out.validity.add("beyond a shear strain of 0.5 % the laws of G(strain) are not valid: strength governs");
  else if (s.strain > 2e-4)
    out.validity.add(
        "above a shear strain of about 0.02 % cycles compact drained sand, or raise its pore pressure: "
        "the result depends on their number");
  return out;
}

} // namespace granum::sands
