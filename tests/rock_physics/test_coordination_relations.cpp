// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/rock_physics/sphere_packs.hpp>

#include "unit.hpp"

using rock_physics::coordination_number;
using Relation = rock_physics::CoordinationRelation;

namespace {
constexpr Relation relations[] = {Relation::murphy_table, Relation::murphy_quadratic,
                                  Relation::murphy_exponential};
}

TEST_CASE("coordination relations: the table's own points, both ends included") {
  CHECK(coordination_number(0.2, Relation::murphy_table) == 14.007);
  CHECK(coordination_number(0.4, Relation::murphy_table) == relative(8.3147, 1e-15));
  CHECK(coordination_number(0.7, Relation::murphy_table) == relative(3.744, 1e-15));
  CHECK(coordination_number(0.375, Relation::murphy_table) == relative((9.5078 + 8.3147) / 2, 1e-15));
}

TEST_CASE("coordination relations: fall with porosity and stay within 0.7 of each other") {
  double spread = 0, last[3] = {15, 15, 15};
  for (int i = 0; i <= 500; ++i) {
    const double porosity = 0.2 + 0.001 * std::min(i, 499);
    double values[3];
    for (int r = 0; r < 3; ++r) {
      values[r] = coordination_number(porosity, relations[r]);
      CHECK(values[r] <= last[r]);
      last[r] = values[r];
    }
    const auto [low, high] = std::minmax_element(values, values + 3);
    spread = std::max(spread, *high - *low);
  }
  CHECK(spread < 0.7);
  CHECK(spread > 0.6);
}

TEST_CASE("coordination relations: nothing is extrapolated or clamped") {
  for (const Relation relation : relations) {
    const auto [low, high] = rock_physics::porosity_range(relation);
    CHECK_NOTHROW((void)coordination_number(low, relation));
    CHECK_NOTHROW((void)coordination_number(high, relation));
    for (const double bad : {std::nextafter(low, 0), std::nextafter(high, 1), 0.0, 1.0, -1.0,
                             std::numeric_limits<double>::quiet_NaN()})
      CHECK_THROWS_AS((void)coordination_number(bad, relation), InvalidArgument);
  }
  CHECK_THROWS_AS((void)coordination_number(0.4, Relation(9)), InvalidArgument);
}
