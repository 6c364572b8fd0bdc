// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/text/source.hpp>

#include "unit.hpp"

using namespace granum::io;
using Names = std::vector<std::string>;

TEST_CASE("file names: numbers in them are compared by their value") {
  const std::string nines = "a9999999999999999999999";
  const Names sorted{"a",        "a1",        "a01",       "a2", "a2b",  "a10",
                     "a10.dump", nines + "8", nines + "9", "b1", "b1c2", "b1c10"};
  for (std::size_t i = 0; i < sorted.size(); ++i)
    for (std::size_t j = 0; j < sorted.size(); ++j) {
      INFO(sorted[i], " ", sorted[j]);
      // 1 and 01 are one number; the plain order decides: "a01" before "a1"
      const bool alike = (i == 1 && j == 2) || (i == 2 && j == 1);
      CHECK(natural_less(sorted[i], sorted[j]) == (alike ? i > j : i < j));
    }
}

TEST_CASE("file names: those that differ only in numbers are one series") {
  CHECK(series_by_name({"out/dense_p20.atoms.gz", "out/dense_p100.atoms.gz", "out/loose_p20.atoms.gz"}) ==
        Names{"dense", "dense", "loose"});
  CHECK(series_by_name({"dense/state.10.dump", "loose/state.10.dump", "dense/state.20.dump"}) ==
        Names{"dense", "loose", "dense"});
  // words that end alike are not cut
  CHECK(series_by_name({"p1-dense", "p1-loose"}) == Names{"dense", "loose"});
  // decimal numbers, and numbers of several parts
  CHECK(series_by_name({"p0.5.dump", "p1.dump", "p1.5.dump"}) == Names(3, "p0.5.dump"));
  CHECK(series_by_name({"x/run1.500", "x/run2.1000"}) == Names(2, "run1.500"));
  CHECK(series_by_name({"one.dump"}) == Names{"one.dump"});
  CHECK(series_by_name({}).empty());
  // one name is the beginning of the other
  CHECK(series_by_name({"sand_p1", "sand_wet_p1"}) == Names{"sand_p#", "wet"});
  CHECK(series_by_name({"a", "b"}) == Names{"a", "b"});
  CHECK(series_by_name({"sable_\xC3\xA9t\xC3\xA9_1", "sable_\xC3\xA9tang_1"}) ==
        Names{"\xC3\xA9t\xC3\xA9", "\xC3\xA9tang"});
}
