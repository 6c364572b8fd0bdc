// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/inverse/quantity.hpp>

#include "unit.hpp"

using namespace granum::inverse;

TEST_CASE("quantities: each has its own row") {
  for (const QuantityRow& row : quantities())
    CHECK(&row_of(row.quantity) == &row);
  CHECK(quantities().size() == 7);
  CHECK(row_of(Quantity::V_p).modulus == granum::effective::Modulus::C33);
  CHECK(row_of(Quantity::V_p).speed);
  CHECK_THROWS_AS((void)row_of(static_cast<Quantity>(99)), granum::InvalidArgument);
}
