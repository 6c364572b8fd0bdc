// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/lammps/arrays.hpp>

#include "unit.hpp"

using namespace granum::io;

TEST_CASE("a column map is a list of quantity=column") {
  CHECK(parse_column_map("").empty());
  const ColumnMap map = parse_column_map("id1=c_cl[1], id2 = c_cl[2],force=v_f");
  CHECK(map == ColumnMap{{"id1", "c_cl[1]"}, {"id2", "c_cl[2]"}, {"force", "v_f"}});
}

TEST_CASE("a column map with a slip is refused") {
  for (const auto& [map, named] :
       {std::pair{"id1", "'id1'"}, {"kq=c_1", "'kq'"}, {"id=", "'id'"}, {"id=a,id=b", "'id'"}})
    CHECK_THROWS_WITH_AS(parse_column_map(map), doctest::Contains(named), InvalidArgument);
}
