// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/sands/known_sands.hpp>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>

#include "constants.hpp"

namespace granum::sands {

namespace {

/// A grading of the series of [WichtmannTriantafyllidis2009].
KnownSand karlsruhe(const char* key, const char* name, double d50, double uniformity, double least,
                    double largest, const SandTests& tests) {
  return {.key = key,
          .name = name,
          .source = "Lo2021",
          .mineral = "quartz",
          .d50 = d50,
          .uniformity = uniformity,
          .least_void_ratio = least,
          .largest_void_ratio = largest,
          .tests = tests};
}

/// The tests: level, power of F, s, count, void ratios, stresses.
const std::array<KnownSand, 25> table{{
    {.key = "toyoura",
     .name = "Toyoura sand",
     .source = "CubrinovskiIshihara2002; YangSze2011",
     .mineral = "quartz",
     .d50 = 0.20 * mm,
     .uniformity = 1.39,
     .least_void_ratio = 0.616,
     .largest_void_ratio = 0.988,
     .tests = SandTests{93.9 * MPa, 1.12, 0.401, 33, 0.672, 0.933, 50 * kPa, 500 * kPa},
     .remark = "of three laboratories"},
    // Densities of 1754 and 1457 kg/m3, of grains of 2650.
    {.key = "ottawa",
     .name = "Ottawa F-65 sand",
     .source = "CareyStoneKutter2020",
     .mineral = "quartz",
     .d50 = 0.20 * mm,
     .least_void_ratio = 0.511,
     .largest_void_ratio = 0.819},
    {.key = "ottawa-20-30",
     .name = "Ottawa 20-30 sand",
     .source = "Lo2021",
     .mineral = "quartz",
     .d50 = 0.619 * mm,
     .uniformity = 1.46,
     .least_void_ratio = 0.502,
     .largest_void_ratio = 0.742,
     .tests = SandTests{51.9 * MPa, 1.19, 0.426, 18, 0.516, 0.665, 50 * kPa, 300 * kPa}},
    {.key = "ottawa-0.39",
     .name = "Ottawa sand, d50 0.39 mm",
     .source = "Lo2021",
     .mineral = "quartz",
     .d50 = 0.39 * mm,
     .uniformity = 1.48,
     .least_void_ratio = 0.480,
     .largest_void_ratio = 0.780,
     .tests = SandTests{60.9 * MPa, 1.00, 0.517, 10, 0.55, 0.61, 50 * kPa, 500 * kPa},
     .remark = "all of them at a void ratio of 0.58, so that the effect of density is that of other sands"},
    {.key = "hostun",
     .name = "Hostun sand",
     .source = "Azeiteiro2017",
     .mineral = "quartz",
     .d50 = 0.33 * mm,
     .uniformity = 1.40,
     .least_void_ratio = 0.660,
     .largest_void_ratio = 1.000,
     .tests = SandTests{76.5 * MPa, 0.75, 0.484, 20, 0.659, 0.794, 25 * kPa, 500 * kPa}},
    {.key = "jumunjin",
     .name = "Jumunjin sand",
     .source = "Lo2021",
     .mineral = "quartz",
     .d50 = 0.56 * mm,
     .uniformity = 1.69,
     .least_void_ratio = 0.605,
     .largest_void_ratio = 0.980,
     .tests = SandTests{88.0 * MPa, 0.79, 0.432, 18, 0.621, 0.860, 50 * kPa, 300 * kPa}},
    {.key = "fujian",
     .name = "Fujian sand",
     .source = "Lo2021",
     .mineral = "quartz",
     .d50 = 0.397 * mm,
     .uniformity = 1.53,
     .least_void_ratio = 0.555,
     .largest_void_ratio = 0.879,
     .tests = SandTests{84.0 * MPa, 1.18, 0.455, 10, 0.621, 0.783, 50 * kPa, 400 * kPa},
     .remark = "three of them over stress, which lie 8 % above the seven at 100 kPa"},
    {.key = "berlin",
     .name = "Berlin sand",
     .source = "Lo2021",
     .mineral = "quartz",
     .d50 = 0.21 * mm,
     .uniformity = 2.38,
     .least_void_ratio = 0.460,
     .largest_void_ratio = 0.750,
     .tests = SandTests{55.1 * MPa, 1.37, 0.466, 16, 0.485, 0.608, 50 * kPa, 400 * kPa},
     .remark = "whose d50, C_u, e_min and e_max are those of other tests of the same name"},
    {.key = "ticino",
     .name = "Ticino sand",
     .source = "Fioravante2015",
     .mineral = "quartz",
     .least_void_ratio = 0.574,
     .largest_void_ratio = 0.923},
    {.key = "nevada",
     .name = "Nevada sand",
     .source = "Arulmoli1992",
     .mineral = "quartz",
     .least_void_ratio = 0.516,
     .largest_void_ratio = 0.894},
    {.key = "longstone",
     .name = "Longstone sand",
     .source = "Tsomokos2010",
     .mineral = "quartz",
     .d50 = 0.15 * mm,
     .uniformity = 1.4,
     .least_void_ratio = 0.614,
     .largest_void_ratio = 0.995},
    karlsruhe("karlsruhe-0.2-1.5", "Karlsruhe sand, d50 0.2 mm, C_u 1.5", 0.2 * mm, 1.5, 0.607, 1.009,
              {81.9 * MPa, 1.18, 0.412, 42, 0.619, 0.828, 50 * kPa, 400 * kPa}),
    karlsruhe("karlsruhe-0.2-2", "Karlsruhe sand, d50 0.2 mm, C_u 2", 0.2 * mm, 2, 0.571, 0.973,
              {72 * MPa, 1.31, 0.417, 56, 0.593, 0.764, 50 * kPa, 400 * kPa}),
    karlsruhe("karlsruhe-0.2-2.5", "Karlsruhe sand, d50 0.2 mm, C_u 2.5", 0.2 * mm, 2.5, 0.557, 0.952,
              {68.7 * MPa, 1.22, 0.412, 42, 0.563, 0.7, 50 * kPa, 400 * kPa}),
    karlsruhe("karlsruhe-0.6-1.5", "Karlsruhe sand, d50 0.6 mm, C_u 1.5", 0.6 * mm, 1.5, 0.583, 0.906,
              {80.7 * MPa, 1.38, 0.397, 42, 0.556, 0.763, 50 * kPa, 400 * kPa}),
    karlsruhe("karlsruhe-0.6-2", "Karlsruhe sand, d50 0.6 mm, C_u 2", 0.6 * mm, 2, 0.553, 0.879,
              {73.7 * MPa, 1.16, 0.444, 42, 0.538, 0.734, 50 * kPa, 400 * kPa}),
    karlsruhe("karlsruhe-0.6-2.5", "Karlsruhe sand, d50 0.6 mm, C_u 2.5", 0.6 * mm, 2.5, 0.506, 0.87,
              {56.4 * MPa, 1.53, 0.469, 42, 0.522, 0.7, 50 * kPa, 400 * kPa}),
    karlsruhe("karlsruhe-0.6-3", "Karlsruhe sand, d50 0.6 mm, C_u 3", 0.6 * mm, 3, 0.485, 0.843,
              {48.8 * MPa, 1.64, 0.488, 42, 0.5, 0.681, 50 * kPa, 400 * kPa}),
    karlsruhe("karlsruhe-0.6-5", "Karlsruhe sand, d50 0.6 mm, C_u 5", 0.6 * mm, 5, 0.405, 0.761,
              {35.5 * MPa, 1.8, 0.543, 42, 0.452, 0.595, 50 * kPa, 400 * kPa}),
    karlsruhe("karlsruhe-0.6-8", "Karlsruhe sand, d50 0.6 mm, C_u 8", 0.6 * mm, 8, 0.366, 0.686,
              {34.2 * MPa, 1.67, 0.536, 35, 0.398, 0.522, 50 * kPa, 400 * kPa}),
    karlsruhe("karlsruhe-2-1.5", "Karlsruhe sand, d50 2 mm, C_u 1.5", 2 * mm, 1.5, 0.603, 0.891,
              {82.8 * MPa, 1.16, 0.43, 42, 0.603, 0.747, 50 * kPa, 400 * kPa}),
    karlsruhe("karlsruhe-2-2", "Karlsruhe sand, d50 2 mm, C_u 2", 2 * mm, 2, 0.566, 0.84,
              {68.5 * MPa, 1.24, 0.475, 42, 0.56, 0.699, 50 * kPa, 400 * kPa}),
    karlsruhe("karlsruhe-2-2.5", "Karlsruhe sand, d50 2 mm, C_u 2.5", 2 * mm, 2.5, 0.524, 0.824,
              {61.1 * MPa, 1.28, 0.482, 42, 0.516, 0.66, 50 * kPa, 400 * kPa}),
    karlsruhe("karlsruhe-2-3", "Karlsruhe sand, d50 2 mm, C_u 3", 2 * mm, 3, 0.503, 0.797,
              {44.8 * MPa, 1.73, 0.496, 35, 0.49, 0.605, 50 * kPa, 400 * kPa}),
    karlsruhe("karlsruhe-2-5", "Karlsruhe sand, d50 2 mm, C_u 5", 2 * mm, 5, 0.412, 0.716,
              {43.5 * MPa, 1.38, 0.553, 35, 0.405, 0.526, 50 * kPa, 400 * kPa}),
}};

} // namespace

std::span<const KnownSand> known_sands() { return table; }

const KnownSand& known_sand(std::string_view key) {
  std::vector<std::string> known;
  for (const KnownSand& sand : table) {
    if (same_word(key, sand.key))
      return sand;
    known.emplace_back(sand.key);
  }
  throw InvalidArgument(unknown_word("sand", key, known));
}

void require_void_ratio_limits(double least, double largest) {
  constexpr double densest = 0.1, loosest = 5, least_distance = 0.05;
  require_closed("least_void_ratio", least, densest, loosest - least_distance);
  constexpr double rounding = 1e-9;
  if (!(largest >= least + least_distance - rounding && largest <= loosest))
    throw InvalidArgument("largest_void_ratio", largest, "",
                          detail::closed_range(least + least_distance, loosest, largest) +
                              ": e_max is larger than e_min, " + short_text(least) + ", by " +
                              short_text(least_distance) + " at least");
}

double void_ratio_of_relative_density(double relative_density, double least, double largest) {
  require_closed("relative_density", relative_density, 0, 1.2);
  require_void_ratio_limits(least, largest);
  return require_positive("void_ratio", largest - relative_density * (largest - least));
}

namespace {

/// coefficient (zero - e)^2/(1 + e) (p/kPa)^1/2, in kPa.
double by_root(double coefficient, double void_ratio_factor, const SandState& s) {
  return kPa * coefficient * void_ratio_factor * std::sqrt(s.mean_stress / kPa);
}

double hardin_richart_round(const SandState& s) {
  return by_root(6908, hardin_richart_factor(2.17, s.void_ratio), s);
}

double hardin_richart_angular(const SandState& s) {
  return by_root(3230, hardin_richart_factor(2.97, s.void_ratio), s);
}

double kokusho(const SandState& s) { return by_root(8400, hardin_richart_factor(2.17, s.void_ratio), s); }

double jamiolkowski(const SandState& s) {
  return kPa * 600 * std::pow(s.void_ratio, -1.3) * std::sqrt(s.mean_stress / kPa * (reference_stress / kPa));
}

double wichtmann_triantafyllidis(const SandState& s) {
  const double A = 1563 + 3.13 * std::pow(s.uniformity, 2.98);
  const double zero = 1.94 * std::exp(-0.066 * s.uniformity);
  const double n = 0.40 * std::pow(s.uniformity, 0.18);
  return A * hardin_richart_factor(zero, s.void_ratio) * reference_stress *
         std::pow(s.mean_stress / reference_stress, n);
}

double oztoprak_bolton(const SandState& s) {
  return 5760 * reference_stress * std::pow(1 + s.void_ratio, -3) *
         std::pow(s.mean_stress / reference_stress, 0.49);
}

double menq(const SandState& s) {
  const double x = -1 - std::pow(s.d50 / (20 * mm), 0.75);
  return 67.1 * MPa * std::pow(s.uniformity, -0.2) * std::pow(s.void_ratio, x) *
         std::pow(s.mean_stress / standard_atmosphere, 0.48 * std::pow(s.uniformity, 0.09));
}

double wang_stokoe_by_void_ratio(const SandState& s) {
  return 67.5 * MPa * std::pow(s.void_ratio, -0.86) * std::sqrt(s.mean_stress / standard_atmosphere);
}

double wang_stokoe_by_grading(const SandState& s) {
  return 64.3 * MPa * std::pow(s.uniformity, -0.21) *
         std::pow(s.void_ratio, -1.08 - std::pow(0.09 * s.d50 / mm, 0.51)) *
         std::pow(s.mean_stress / standard_atmosphere, 0.47 * std::pow(s.uniformity, 0.06));
}

const std::array<MeasuredLaw, 9> laws{{
    {"hardin-richart-round",
     "round-grained sands (Ottawa)",
     "HardinRichart1963",
     "6908 (2.17-e)^2/(1+e) p^0.5",
     {0.35, 0.80, 20 * kPa, 500 * kPa},
     {0.84, 0.101},
     hardin_richart_round},
    {"hardin-richart-angular",
     "angular-grained sands (crushed quartz)",
     "HardinRichart1963",
     "3230 (2.97-e)^2/(1+e) p^0.5",
     {0.60, 1.30, 20 * kPa, 500 * kPa},
     {0.94, 0.069},
     hardin_richart_angular},
    {"kokusho",
     "Toyoura sand",
     "Kokusho1980",
     "8400 (2.17-e)^2/(1+e) p^0.5",
     {0.64, 0.90, 20 * kPa, 300 * kPa},
     {1.02, 0.069},
     kokusho},
    {"jamiolkowski",
     "natural soils",
     "Jamiolkowski1991",
     "600 e^-1.3 (p p_a)^0.5",
     {0.40, 1.50, 20 * kPa, 500 * kPa},
     {0.93, 0.076},
     jamiolkowski},
    {"menq",
     "sands and gravels by their grading",
     "Menq2003",
     "67.1 MPa C_u^-0.2 e^x (p/atm)^(0.48 C_u^0.09), x = -1-(d50/20 mm)^0.75",
     {0.40, 1.00, 20 * kPa, 1000 * kPa, 15},
     {0.87, 0.083},
     menq},
    {"wichtmann-triantafyllidis",
     "quartz sand of 25 gradings",
     "WichtmannTriantafyllidis2009",
     "(1563 + 3.13 C_u^2.98) (a-e)^2/(1+e) p^n p_a^(1-n), a = 1.94 exp(-0.066 C_u), n = 0.40 C_u^0.18",
     {0.40, 0.90, 50 * kPa, 400 * kPa, 8},
     {0.96, 0.071},
     wichtmann_triantafyllidis},
    {"oztoprak-bolton",
     "sands of a database of 454 tests",
     "OztoprakBolton2013",
     "5760 p_a (1+e)^-3 (p/p_a)^0.49",
     {0.30, 1.20, 10 * kPa, 1000 * kPa},
     {1.13, 0.083},
     oztoprak_bolton},
    {"wang-stokoe-1",
     "clean sands by void ratio",
     "WangStokoe2022",
     "67.5 MPa e^-0.86 (p/atm)^0.5",
     {0.40, 1.00, 20 * kPa, 1000 * kPa},
     {0.88, 0.085},
     wang_stokoe_by_void_ratio},
    {"wang-stokoe-3",
     "clean sands by grading",
     "WangStokoe2022",
     "64.3 MPa C_u^-0.21 e^(-1.08-(0.09 d50/mm)^0.51) (p/atm)^(0.47 C_u^0.06)",
     {0.40, 1.00, 20 * kPa, 1000 * kPa, 8},
     {0.90, 0.075},
     wang_stokoe_by_grading},
}};

void note_outside(const char* what, double value, double low, double high, const char* unit,
                  Validity& validity) {
  if (value < low || value > high)
    validity.add(std::string(what) + " of " +
                 detail::refused_text(value, detail::closed_range(low, high, value), 4) + unit +
                 " is outside of the range of the tests, " + short_text(low) + " to " + short_text(high) +
                 unit);
}

} // namespace

std::span<const MeasuredLaw> measured_laws() { return laws; }

const MeasuredLaw& measured_law(std::string_view key) {
  std::string known;
  for (const MeasuredLaw& law : laws) {
    if (key == law.key)
      return law;
    known += (known.empty() ? "" : ", ") + std::string(law.key);
  }
  throw InvalidArgument("law of measured sands '" + std::string(key) + "' is unknown; known are " + known);
}

double hardin_richart_factor(double zero, double e) {
  require_open("void_ratio", e, 0, zero);
  return (zero - e) * (zero - e) / (1 + e);
}

SandModulus shear_modulus(const MeasuredLaw& law, const SandState& sand) {
  require_positive("void_ratio", sand.void_ratio);
  require_positive("mean_stress", sand.mean_stress, "Pa");
  require_closed("uniformity", sand.uniformity, 1, 1e3);
  constexpr double largest_boulder = 1; // [m]; powers of d50 overflow far beyond
  require_open("d50", sand.d50, 0, largest_boulder, "m");
  SandModulus answer{.shear_modulus = law.modulus(sand), .validity = {}};
  const TestedRange& tested = law.tested;
  note_outside("void ratio", sand.void_ratio, tested.void_ratio_low, tested.void_ratio_high, "",
               answer.validity);
  note_outside("mean stress", sand.mean_stress / kPa, tested.stress_low / kPa, tested.stress_high / kPa,
               " kPa", answer.validity);
  if (tested.uniformity_high > 0)
    note_outside("C_u", sand.uniformity, 1, tested.uniformity_high, "", answer.validity);
  return answer;
}

} // namespace granum::sands
