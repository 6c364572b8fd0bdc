// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/contact/grains.hpp>

#include <cmath>
#include <set>
#include <string>

#include <doctest/doctest.h>
#include <granum/core/error.hpp>

using namespace granum;
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
