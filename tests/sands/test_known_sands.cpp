// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/sands/known_sands.hpp>

#include <set>

#include <granum/contact/grains.hpp>

#include "thresholds.hpp"
#include "unit.hpp"

using namespace granum::sands;

TEST_CASE(
    "known sands: keys are unique and found as they are spelt on a bag, numbers possible, minerals known") {
  std::set<std::string> keys;
  for (const KnownSand& sand : known_sands()) {
    CHECK(keys.insert(sand.key).second);
    CHECK(&known_sand(sand.key) == &sand);
    CHECK(contact::mineral(sand.mineral).density > 2000);
    CHECK(sand.least_void_ratio.has_value() == sand.largest_void_ratio.has_value());
    if (sand.least_void_ratio)
      CHECK(*sand.least_void_ratio < *sand.largest_void_ratio);
    if (sand.d50)
      CHECK((*sand.d50 > 0.05e-3 && *sand.d50 <= 2e-3));
  }
  CHECK_THROWS_WITH_AS((void)known_sand("sahara"), doctest::Contains("toyoura, ottawa"), InvalidArgument);
  for (const char* name : {"Ottawa 20-30", "ottawa_20-30", "ottawa-20-30"})
    CHECK(std::string_view(known_sand(name).key) == "ottawa-20-30");
  CHECK_THROWS_AS((void)known_sand("Ottawa 20"), InvalidArgument);
}

TEST_CASE("known sands: relative density runs from the loosest to the densest, as of Ottawa F-65") {
  CHECK(void_ratio_of_relative_density(0, 0.6, 1.0) == 1.0);
  CHECK(void_ratio_of_relative_density(1, 0.6, 1.0) == doctest::Approx(0.6).epsilon(1e-15));
  CHECK(void_ratio_of_relative_density(0.5, 0.6, 1.0) == doctest::Approx(0.8).epsilon(1e-15));
  for (const auto& [D_r, least] : {std::pair{60.0, 0.6}, {0.5, 1.2}, {0.5, 0.0}})
    CHECK_THROWS_AS((void)void_ratio_of_relative_density(D_r, least, 1.0), InvalidArgument);
  const auto refused = [](double least, double largest) {
    return refusals([&] { require_void_ratio_limits(least, largest); });
  };
  check_threshold(0.1, [&](double least) { return refused(least, 1); });
  for (const double most : {0.65, 5.0})
    check_threshold(most, [&](double largest) { return refused(0.6, largest); });
  const KnownSand& sand = known_sand("ottawa");
  CHECK(std::abs(*sand.least_void_ratio - (2650.0 / 1754 - 1)) < 5e-4);
  CHECK(std::abs(*sand.largest_void_ratio - (2650.0 / 1457 - 1)) < 5e-4);
}
