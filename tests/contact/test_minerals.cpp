// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/contact/grains.hpp>

#include <set>

#include <granum/core/text.hpp>

#include "thresholds.hpp"
#include "unit.hpp"

using namespace granum::contact;

TEST_CASE("minerals: bulk moduli and densities as they are printed") {
  const struct {
    const char* key;
    double K, density; // GPa, g/cm3
  } printed[] = {
      {"quartz", 37, 2.65}, {"feldspar", 37.5, 2.62}, {"calcite", 77, 2.71}, {"dolomite", 95, 2.87}};
  for (const auto& [key, K, density] : printed) {
    CHECK(std::abs(bulk_modulus(mineral(key).material) / (K * 1e9) - 1) < 1e-13);
    CHECK(std::abs(mineral(key).density / (1e3 * density) - 1) < 1e-13);
  }
}

TEST_CASE("minerals: keys are unique, values possible, an unknown one names the others") {
  std::set<std::string> keys;
  for (const Mineral& m : minerals()) {
    CHECK(keys.insert(m.key).second);
    CHECK(&mineral(m.key) == &m);
    CHECK(m.material.poisson_ratio > 0);
    CHECK(m.material.poisson_ratio < 0.5);
    CHECK(m.material.shear_modulus > 10e9);
    CHECK(m.modulus_spread > 0);
  }
  CHECK_THROWS_WITH_AS((void)mineral("cheese"), doctest::Contains("quartz, feldspar"), InvalidArgument);
}

TEST_CASE("minerals: the bulk modulus of the incompressible limit is the largest number") {
  CHECK(bulk_modulus({1e9, 0.5}) == std::numeric_limits<double>::max());
  CHECK(bulk_modulus({1e9, 0.25}) == doctest::Approx(5e9 / 3));
  CHECK_THROWS_AS((void)bulk_modulus({1e9, 0.6}), InvalidArgument);
}

TEST_CASE("minerals: one, or several by their shares") {
  const auto parts = mineral_shares("quartz:0.7,calcite:30%");
  REQUIRE(parts.size() == 2);
  CHECK(parts[0].mineral == &mineral("quartz"));
  CHECK(parts[1].mineral == &mineral("calcite"));
  CHECK(parts[0].share == 0.7);
  CHECK(parts[1].share == 0.3);
  CHECK(text_of(parts) == "quartz:70%,calcite:30%");
  CHECK(text_of(mineral_shares("glass")) == "glass");
  CHECK(mineral_shares("glass")[0].share == 1);
  CHECK(text_of({}).empty());
  check_threshold(1e-6, [](double off) { // rounding of the sum
    try {
      return mineral_shares("quartz:0.7,calcite:" + exact_text(0.3 + off)).empty() ? 9 : 0;
    } catch (const InvalidArgument&) {
      return 1;
    }
  });
  for (const char* bad :
       {"", "quartz:0.7", "quartz:0.7,calcite:0.4", "quartz:0.5,quartz:0.5", "quartz,calcite",
        "quartz:-1,calcite:2", "quartz:1,calcite:0", "quartz:0.5,cheese:0.5", "quartz:,",
        "quartz:0.5,calcite:0.5,", "quartz:70kPa,calcite:30%", "quartz:nan,calcite:0.5"})
    CHECK_THROWS_AS((void)mineral_shares(bad), InvalidArgument);
}
