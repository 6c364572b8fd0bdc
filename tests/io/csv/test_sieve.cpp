// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/csv/table.hpp>

#include "unit.hpp"

using namespace granum::io;

namespace {

std::vector<sizes::SievePoint> curve_of(const std::string& text) {
  return sieve_curve(CsvTable("sieves.csv", text));
}

} // namespace

TEST_CASE("a sieve curve in either order and in any unit") {
  for (const char* text :
       {"d_mm,passing_%\n0.1,0\n0.4,60\n2,100\n", "passing,d_um\n1,2000\n0.6,400\n0,100\n",
        "# sand\n\nsample,d_m,passing_%,remark\nA,1e-4,0,\nA,4e-4,60,coarse\nA,2e-3,100,\n"}) {
    CAPTURE(text);
    const auto curve = curve_of(text);
    REQUIRE(curve.size() == 3);
    CHECK(curve[0].diameter == relative(1e-4, 1e-15));
    CHECK(curve[0].passing == 0);
    CHECK(curve[1].diameter == relative(4e-4, 1e-15));
    CHECK(curve[1].passing == relative(0.6, 1e-15));
    CHECK(curve[2].diameter == relative(2e-3, 1e-15));
    CHECK(curve[2].passing == 1);
  }
}

TEST_CASE("a file that is no sieve curve is refused at its line") {
  const std::vector<std::pair<const char*, std::vector<const char*>>> wrong{
      {"sieves.csv:2:",
       {"d_mm,passing_%\n0.1,0\n", "d_mm,passing_%\n0,0\n0.4,60\n2,100\n",
        "d_mm,passing_%\n0.1,-1\n0.4,60\n2,100\n", "d_mm,passing_%\n0.1,5\n2,100\n",
        "d_mm,passing_%\n0.1,nan\n2,100\n"}},
      {"sieves.csv:3:",
       {"d_mm,passing_%\n0.1,0\n0.1,60\n2,100\n", "d_mm,passing_%\n2,100\n1,50\n0.4,60\n0.1,0\n",
        "d_mm,passing\n0.1,0\n0.4,60\n2,100\n", "d_mm,passing_%\n0.1,0\n2,99\n",
        "d_nm,passing_%\n1,0\n1e9,100\n", "d_mm,passing_%\n0.1,0\nx,60\n2,100\n",
        "d_mm,passing_%\n0.1,0\n1,\n2,100\n", "d_mm,passing_%\n0.1,0\n1\n2,100\n"}},
      {"sieves.csv:4:", {"d_mm,passing_%\n0.1,0\n0.4,60\n1,50\n2,100\n"}},
      {"sieves.csv:",
       {"d,passing_%\n0.1,0\n2,100\n", "d_mm\n0.1\n2\n", "d_mm,passing_%\n", "",
        "d_mm,passing_%,d_um\n0.1,0,100\n2,100,2000\n"}}};
  for (const auto& [place, texts] : wrong)
    for (const std::string text : texts) {
      CAPTURE(text);
      CHECK_THROWS_WITH_AS((void)curve_of(text), doctest::Contains(place), FileError);
    }
  CHECK_THROWS_AS((void)read_sieve_curve("no/such/file.csv"), FileError);
}
