// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/lammps/arrays.hpp>

#include <doctest/doctest.h>
#include <granum/core/error.hpp>

using namespace granum;
using namespace granum::io;

TEST_CASE("a column map is a list of quantity=column") {
  CHECK(parse_column_map("").empty());
  const ColumnMap map = parse_column_map("id1=c_cl[1], id2 = c_cl[2],force=v_f");
  CHECK(map == ColumnMap{{"id1", "c_cl[1]"}, {"id2", "c_cl[2]"}, {"force", "v_f"}});
}

TEST_CASE("a column map with a slip is refused") {
  CHECK_THROWS_WITH_AS(parse_column_map("id1"), "column map: expected quantity=column, found 'id1'",
                       InvalidArgument);
  CHECK_THROWS_WITH_AS(parse_column_map("kq=c_1"), "column map: 'kq' is no quantity of a dump",
                       InvalidArgument);
  CHECK_THROWS_WITH_AS(parse_column_map("id="), "column map: no column is given for 'id'", InvalidArgument);
  CHECK_THROWS_WITH_AS(parse_column_map("id=a,id=b"), "column map: 'id' is given twice", InvalidArgument);
}
