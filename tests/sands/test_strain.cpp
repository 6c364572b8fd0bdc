// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/sands/strain.hpp>

#include "unit.hpp"

#include <thresholds.hpp>
using namespace granum::sands;

namespace {

StrainedSand sand(double strain, double p) { return {.strain = strain, .void_ratio = 0.7, .mean_stress = p}; }

} // namespace

TEST_CASE("strain: G/G0 of the fit worked by hand, with one and two deviations") {
  // 0.1 %, 100 kPa, C_u 1.39: g_r = 0.062 % 1.39^-0.3
  StrainedSand s = sand(1e-3, 100e3);
  s.sand.uniformity = 1.39;
  const auto by_hand = [](double factor) {
    return 1 / (1 + std::pow(0.1 / (0.062 * std::pow(1.39, -0.3) * factor), 0.81));
  };
  CHECK(strained(s).ratio == relative(by_hand(1), 1e-14));
  CHECK(strained(s).ratio == doctest::Approx(0.385).epsilon(0.002));
  for (const double k : {-2.0, -1.0, 1.0, 2.0})
    CHECK(strained(s, {.reference_strain = k}).ratio ==
          relative(by_hand(std::pow(1.6, k)) + 0.01 * k, 1e-13));
  CHECK(strained(sand(1e-7, 100e3), {.reference_strain = 2}).ratio == 1);
  CHECK(strained(sand(5e-2, 1e3), {.reference_strain = -2}).ratio == 0);
}

TEST_CASE("strain: one deviation includes the laws of two data bases at 0.1 % and 100 kPa") {
  StrainedSand s = sand(1e-3, 100e3);
  s.void_ratio = 0.765;
  s.sand = {.uniformity = 1.39, .relative_density = 0.6};
  const double low = strained(s, {.reference_strain = -1}).ratio,
               high = strained(s, {.reference_strain = 1}).ratio;
  for (const StrainLaw& law : strain_laws())
    if (law.key == std::string_view("oztoprak-bolton") || law.key == std::string_view("wang-stokoe-e-C_u")) {
      CAPTURE(law.key);
      CHECK(law.ratio(s) > low);
      CHECK(law.ratio(s) < high);
    }
}

TEST_CASE("strain: every law falls with strain and rises with stress, from 1") {
  for (const StrainLaw& law : strain_laws()) {
    CAPTURE(law.key);
    CHECK(law.ratio(sand(1e-7, 100e3)) > 0.99);
    double last = 1.01;
    for (const double strain : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2}) {
      const double ratio = law.ratio(sand(strain, 100e3));
      CHECK(ratio < last);
      CHECK(ratio > 0);
      CHECK(law.ratio(sand(strain, 200e3)) >= ratio);
      last = ratio;
    }
    for (const double e : {0.05, 0.1, 0.13, 0.4, 1.5}) { // a number for every void ratio
      const double ratio = law.ratio({.strain = 1e-4, .void_ratio = e, .mean_stress = 100e3});
      CHECK(ratio > 0);
      CHECK(ratio <= 1);
    }
  }
  const auto law = std::find_if(strain_laws().begin(), strain_laws().end(), [](const StrainLaw& one) {
    return std::string_view(one.key) == "darendeli";
  });
  REQUIRE(law != strain_laws().end());
  CHECK(law->ratio(sand(0.0352e-2, 101.325e3)) == relative(0.5, 1e-14));
}

TEST_CASE("strain: damping of the centre, and each of its parts moved") {
  // D_min at 100 kPa is 0.8 %; 3.6 and 11.7 % are those of the centre at 0.01 and 0.1 %
  CHECK(strained(sand(1e-9, 100e3)).damping == doctest::Approx(0.008).epsilon(0.001));
  CHECK(strained(sand(1e-4, 100e3)).damping == doctest::Approx(0.036).epsilon(0.02));
  CHECK(strained(sand(1e-3, 100e3)).damping == doctest::Approx(0.117).epsilon(0.01));
  const StrainedSand s = sand(1e-3, 400e3);
  const StrainAnswer middle = strained(s);
  const double least = 0.008 * std::pow(4, -0.15), grown = 0.195 * std::pow(1 - middle.ratio, 1.22);
  CHECK(middle.damping == relative(least + grown, 1e-13));
  CHECK(strained(s, {.least_damping = 1}).damping == relative(1.6 * least + grown, 1e-13));
  CHECK(strained(s, {.damping_growth = -1}).damping == relative(least + grown / 1.3, 1e-13));
  CHECK(strained(s, {.reference_strain = -1}).damping > middle.damping);
  CHECK(strained(sand(small_strain, 50e3)).ratio > 0.93);
}

TEST_CASE("strain: notes if cycles matter or laws end, impossible strains are refused") {
  CHECK(strained(sand(1e-4, 100e3)).validity.ok());
  check_threshold(2e-4, [](double x) { return strained(sand(x, 100e3)).validity.notes.size(); });
  CHECK(strained(sand(0.0101, 100e3)).validity.notes != strained(sand(0.0099, 100e3)).validity.notes);
  CHECK_NOTHROW((void)strained(sand(0.0499, 100e3)));
  CHECK_THROWS_AS((void)strained(sand(0.0501, 100e3)), InvalidArgument);
  CHECK_THROWS_AS((void)strained(sand(0, 100e3)), InvalidArgument);
  CHECK_THROWS_AS((void)strained(sand(1e-4, 0)), InvalidArgument);
}
