// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/sweep/partition.hpp"

#include "unit.hpp"

using namespace granum::dem;

namespace {

template <std::size_t numbers>
struct Row {
  double of[numbers];
};

} // namespace

TEST_CASE_TEMPLATE("a place leads to the row of its number, however long rows are", OneRow, double, Row<2>,
                   Row<4>, Row<8>) {
  constexpr std::uint32_t count = 11;
  std::vector<OneRow> rows(count);
  for (std::uint32_t k = 0; k < count; ++k) {
    CHECK(&row_at(rows.data(), RowPlace::of(k)) == &rows[k]);
    CHECK(&row_at<const OneRow>(rows.data(), RowPlace::of(k)) == &rows[k]);
    CHECK(RowPlace::of(k).number() == k);
  }
  constexpr auto last = static_cast<std::uint32_t>(RowPlace::most_rows);
  CHECK(RowPlace::of(last).number() == last);
  CHECK(RowPlace::of(last + 1).number() != last + 1);
}

TEST_CASE("a listed pair keeps its four places apart") {
  constexpr auto last = static_cast<std::uint32_t>(RowPlace::most_rows);
  for (const std::uint32_t number : {0u, 1u, 12345u, last}) {
    const RowPlace other = RowPlace::of(last - number);
    const ListedPair pair(RowPlace::of(number), other, RowPlace::of(number / 2), RowPlace::of(number / 3));
    CHECK(pair.i().number() == number);
    CHECK(pair.j() == other);
    CHECK(pair.image().number() == number / 2);
    CHECK(pair.row().number() == number / 3);
  }
}
