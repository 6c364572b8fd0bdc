// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/sands/known_sands.hpp>

#include "formula.hpp"
#include "unit.hpp"
#include <granum/sands/pooled_law.hpp>
#include <granum/sands/strain.hpp>
#include <thresholds.hpp>
using namespace granum::sands;

namespace {

double modulus(const char* key, const SandState& sand) {
  return shear_modulus(measured_law(key), sand).shear_modulus;
}

} // namespace

TEST_CASE("laws of sands and of their strain have the values of the formulas that they state") {
  for (const double e : {0.55, 0.8})
    for (const double p : {60.0, 250.0}) // kPa
      for (const double C_u : {1.3, 5.0})
        for (const double d50 : {0.2, 2.0}) // mm
          for (const double D_r : {0.3, 0.8}) {
            std::map<std::string, double> values{{"e", e},         {"p", p},     {"p'", p},    {"p_a", 100},
                                                 {"atm", 101.325}, {"C_u", C_u}, {"D_r", D_r}, {"d50", d50},
                                                 {"e_min", 0.5},   {"%", 0.01},  {"mm", 1},    {"MPa", 1000}};
            const auto formula = [&](const std::string& text) {
              return granum::test::Formula(text, values).value();
            };
            for (const MeasuredLaw& law : measured_laws()) {
              CAPTURE(law.key);
              CHECK(law.modulus({e, 1e3 * p, C_u, 1e-3 * d50}) ==
                    relative(1e3 * formula(law.formula), 1e-12));
            }
            const UsualLimits of = usual_limits(C_u);
            for (const StrainLaw& law : strain_laws()) { // without D_r, that of the void ratio
              values["g"] = 1e-4;
              values["D_r"] = std::clamp((of.largest - e) / (of.largest - of.least), 0.0, 1.0);
              const StrainedSand s{
                  .strain = 1e-4, .void_ratio = e, .mean_stress = 1e3 * p, .sand = {.uniformity = C_u}};
              CHECK(law.ratio(s) == relative(std::min(1.0, formula(law.formula)), 1e-12));
            }
            values["D_r"] = D_r;
            for (const StrainLaw& law : strain_laws())
              for (const double g : {2e-5, 1e-3}) {
                CAPTURE(law.key);
                values["g"] = g;
                const StrainedSand s{.strain = g,
                                     .void_ratio = e,
                                     .mean_stress = 1e3 * p,
                                     .sand = {.uniformity = C_u, .relative_density = D_r}};
                CHECK(law.ratio(s) == relative(std::min(1.0, formula(law.formula)), 1e-12));
              }
            const Sand limited{.least_void_ratio = 0.5, .largest_void_ratio = (e - 0.5 * D_r) / (1 - D_r)};
            for (const Sand& sand : {Sand{}, Sand{.uniformity = C_u}, Sand{.relative_density = D_r}, limited,
                                     Sand{.tests = known_sand("hostun").tests}}) {
              values["s"] = growth_exponent(sand, 1e3 * p).value;
              CHECK(extrapolated_shear_modulus(sand, e, 1e3 * p) ==
                    relative(1e3 * formula(sands::formula(sand)), 1e-4));
            }
          }
}

TEST_CASE("a law reports values outside of its tests") {
  for (const MeasuredLaw& law : measured_laws()) {
    CAPTURE(law.key);
    const SandState usual{0.7, 100e3};
    CHECK(shear_modulus(law, usual).validity.ok());
    const auto threshold = [&](double at, double SandState::*member) {
      check_threshold(at, [&](double value) {
        SandState sand = usual;
        sand.*member = value;
        return shear_modulus(law, sand).validity.notes.size();
      });
    };
    for (const double at : {law.tested.void_ratio_low, law.tested.void_ratio_high})
      threshold(at, &SandState::void_ratio);
    for (const double at : {law.tested.stress_low, law.tested.stress_high})
      threshold(at, &SandState::mean_stress);
    if (law.tested.uniformity_high > 0)
      threshold(law.tested.uniformity_high, &SandState::uniformity);
    else
      CHECK(shear_modulus(law, {0.7, 100e3, 30}).validity.ok());
  }
}

TEST_CASE("impossible sands are refused, of Toyoura sand at 98 kPa 107, 88 and 71 MPa are cited") {
  for (const MeasuredLaw& law : measured_laws()) {
    CAPTURE(law.key);
    CHECK_THROWS_AS((void)shear_modulus(law, {0, 100e3}), InvalidArgument);
    CHECK_THROWS_AS((void)shear_modulus(law, {0.7, -1}), InvalidArgument);
    for (const double C_u : {0.5, 1001.0})
      CHECK_THROWS_AS((void)shear_modulus(law, {0.7, 100e3, C_u}), InvalidArgument);
    CHECK_THROWS_AS((void)shear_modulus(law, {0.7, 100e3, 1.5, 1}), InvalidArgument); // d50 of a metre
  }
  CHECK_THROWS_AS((void)modulus("kokusho", {2.2, 100e3}), InvalidArgument);
  CHECK_THROWS_AS((void)modulus("wichtmann-triantafyllidis", {1.9, 100e3, 3}), InvalidArgument);
  CHECK_THROWS_WITH((void)measured_law("iwasaki"),
                    doctest::Contains("hardin-richart-round, hardin-richart-angular, kokusho"));
  CHECK(modulus("kokusho", {0.7, 98e3}) == relative(107e6, 0.015));
  CHECK(modulus("kokusho", {0.8, 98e3}) == relative(88e6, 0.015));
  CHECK(modulus("kokusho", {0.9, 98e3}) == relative(71e6, 0.015));
}
