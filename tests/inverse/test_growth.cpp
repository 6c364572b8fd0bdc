// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/inverse/quantity.hpp>

#include "unit.hpp"

using namespace granum::inverse;

TEST_CASE("growths and specimens: each is found by its name, an unknown one is refused") {
  for (const GrowthRule growth : all_growth_rules)
    CHECK(growth_rule_of(name(growth)) == growth);
  for (const AskedPacking specimen : all_asked_packings)
    CHECK(asked_packing_of(name(specimen)) == specimen);
  CHECK_THROWS_WITH_AS((void)growth_rule_of("Fixed"), doctest::Contains("fitted"), granum::InvalidArgument);
  CHECK_THROWS_WITH_AS((void)asked_packing_of(""), doctest::Contains("same"), granum::InvalidArgument);
  CHECK_THROWS_WITH_AS((void)quantity_of("E"), doctest::Contains("V_p_h"), granum::InvalidArgument);
  CHECK_THROWS_AS((void)name(static_cast<GrowthRule>(9)), granum::InvalidArgument);
  CHECK_THROWS_AS((void)name(static_cast<AskedPacking>(9)), granum::InvalidArgument);
}

TEST_CASE("quantities: each has its own row") {
  for (const QuantityRow& row : quantities())
    CHECK(&row_of(row.quantity) == &row);
  CHECK(row_of(Quantity::V_p).modulus == granum::effective::Modulus::C33);
  CHECK(row_of(Quantity::V_p).speed);
  CHECK_THROWS_AS((void)row_of(static_cast<Quantity>(99)), granum::InvalidArgument);
}
