// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/estimate/answer.hpp>

#include <set>

#include "unit.hpp"

TEST_CASE("fields: keys and columns are unique, and find their row") {
  std::set<std::string> keys, columns;
  for (const estimate::FieldRow& row : estimate::fields()) {
    CHECK(keys.insert(row.key).second);
    CHECK(columns.insert(row.column).second);
    CHECK(&estimate::field_of(row.key) == &row);
    CHECK(&estimate::row_of(row.field) == &row);
    CHECK(row.least < row.most);
  }
  CHECK(keys.size() == estimate::field_count);
  CHECK_THROWS_AS((void)estimate::field_of("stiffness"), InvalidArgument);
}

TEST_CASE("fields: the index of a row is its field") {
  for (std::size_t k = 0; k < estimate::field_count; ++k)
    CHECK(static_cast<std::size_t>(estimate::fields()[k].field) == k);
}
