// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/estimate/answer.hpp>

#include <set>

#include "unit.hpp"

TEST_CASE("fields: keys and columns are unique, and find their row, whose index is the field") {
  std::set<std::string> keys, columns;
  for (std::size_t k = 0; k < estimate::field_count; ++k) {
    const estimate::FieldRow& row = estimate::fields()[k];
    CHECK(keys.insert(row.key).second);
    CHECK(columns.insert(row.column).second);
    CHECK(&estimate::field_of(row.key) == &row);
    CHECK(&estimate::row_of(row.field) == &row);
    CHECK(static_cast<std::size_t>(row.field) == k);
    CHECK(row.least < row.most);
  }
  CHECK_THROWS_AS((void)estimate::field_of("stiffness"), InvalidArgument);
}
