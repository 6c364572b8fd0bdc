// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/csv/columns.hpp>

#include <doctest/doctest.h>

using namespace granum::io;

namespace {

struct Grain {
  double radius = 0;
  std::optional<double> mass = {};
};

const Columns<Grain> columns{
    {"R_m", "radius", [](const Grain& g) { return g.radius; }, ShownColumn{"R [mm]", 8, 2, true, 1e-3}},
    {"", "", [](const Grain& g) { return 2 * g.radius; }, ShownColumn{"d [m]", 7, 3}},
    {"m_kg", "mass", [](const Grain& g) { return g.mass; }, ShownColumn{"m [kg]", 7, 4}},
};

} // namespace

TEST_CASE("one list of columns makes the CSV and the screen") {
  CsvContent csv;
  add_headings(csv, columns);
  for (const Grain& g : {Grain{0.5, 2}, Grain{0.25}}) {
    std::vector<CsvCell> row;
    add_cells(row, columns, g);
    csv.rows.push_back(row);
  }
  CHECK(csv_text(csv) == "R_m,m_kg\n0.5,2\n0.25,\n");
  CHECK(heading_line(columns) == "  R [mm]  d [m] m [kg]");
  CHECK(number_line(columns, Grain{0.5, 2}) == "  500.00      1      2");
  CHECK(number_line(columns, Grain{0.25}) == "  250.00    0.5");
}

TEST_CASE("on the screen some columns stand ahead, in the CSV all stand as they are listed") {
  Columns<Grain> ordered = columns;
  ordered[2].shown->ahead = true;
  CHECK(heading_line(ordered) == " m [kg]  R [mm]  d [m]");
  CHECK(number_line(ordered, Grain{0.5, 2}) == "      2  500.00      1");
  CsvContent csv;
  add_headings(csv, ordered);
  CHECK(csv.headings == std::vector<std::string>{"R_m", "m_kg"});
}

TEST_CASE("a column of texts stands in the CSV, below the notes") {
  const Columns<Grain> named{
      {"size", [](const Grain& g) { return std::string(g.radius > 0.3 ? "large" : "small, round"); }},
      {"m_kg", "", [](const Grain& g) { return g.mass; }},
  };
  CHECK(csv_text(named, {Grain{0.5, 2}, Grain{0.25}}, {{"program", "granum"}}) ==
        "# program: granum\nsize,m_kg\nlarge,2\n\"small, round\",\n");
}

TEST_CASE("what is wider than its column is shown whole") {
  const ShownColumn narrow{"a long heading", 3, 6};
  CHECK(heading_text(narrow) == "a long heading");
  CHECK(number_text(narrow, 123456) == " 123456"); // apart from the number before
  CHECK(number_text(narrow, 123) == " 123");
  CHECK(number_text(narrow, 12) == " 12");
  CHECK(number_text(narrow, std::nullopt) == "   ");
  CHECK(number_text({"a", 3, 4, false, 1, "-"}, std::nullopt) == "  -");
}
