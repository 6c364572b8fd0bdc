// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/csv/columns.hpp>

#include "unit.hpp"

using namespace granum::io;

namespace {

struct Grain {
  double radius = 0;
  std::optional<Measured> mass = {};
  std::size_t contacts = 0;
  const char* name = "";

  [[nodiscard]] double diameter() const { return 2 * radius; }
};

const Columns<Grain> columns{
    {"name", "name", &Grain::name, ShownColumn{.heading = "grain", .width = -7}},
    {"R_m", "radius", &Grain::radius, ShownColumn{"R [mm]", 8, 2, true, 1e-3}},
    {"", "", &Grain::diameter, ShownColumn{"d [m]", 7, 3}},
    {"m_kg", "mass", &Grain::mass,
     ShownColumn{.heading = "m [g]", .width = 11, .digits = 1, .fixed = true, .unit = 1e-3, .absent = "-"}},
    {"contacts", "contacts", &Grain::contacts},
};
const std::vector<Grain> grains{{.radius = 0.5, .mass = Measured{2, 0.5}, .contacts = 6, .name = "large"},
                                {.radius = 0.25, .name = "small, round"}};

} // namespace

TEST_CASE(
    "one list of columns makes the CSV, the table and the list of the screen, and the table of a page") {
  CHECK(csv_text(columns, grains, {{"program", "granum"}}) ==
        "# program: granum\nname,R_m,m_kg,m_kg_error,contacts\nlarge,0.5,2,0.5,6\n"
        "\"small, round\",0.25,,,0\n");
  // what is wider than its column is whole, and apart from the one before
  CHECK(table_text(columns, grains) == "grain    R [mm]  d [m]      m [g]\n"
                                       "large    500.00      1 2000.0+-500.0\n"
                                       "small, round   250.00    0.5          -\n");
  const std::string all = list_text(columns, grains[0]), less = list_text(columns, grains[1]),
                    page = page_table(columns, grains);
  CHECK(all.find("R [mm]                   500.00") != std::string::npos);
  CHECK(all.find("2000.0 +- 5e+02") != std::string::npos); // errors with two digits
  CHECK(std::count(all.begin(), all.end(), '\n') == 4);
  CHECK(std::count(less.begin(), less.end(), '\n') == 3);
  for (const char* part : {"R [mm]", "m [g]", "small, round", "500.00", "2000.0 \u00b1 500.0"})
    CHECK(page.find(part) != std::string::npos);
}

TEST_CASE("values of what getters return") {
  CHECK(is_nothing(value_of(std::optional<double>())));
  CHECK(number_of(value_of(std::optional(2.5))) == 2.5);
  CHECK(number_of(value_of(std::size_t{7})) == 7.0);
  CHECK(number_of(value_of(-7L)) == -7.0);
  CHECK(number_of(value_of(Measured{3, 1})) == 3.0);
  CHECK_FALSE(number_of(value_of(std::string("3"))));
  CHECK(std::get<std::string>(value_of("text")) == "text");
  CHECK(std::get<bool>(value_of(true)));
  const auto mass = or_null(&Grain::mass);
  CHECK(std::holds_alternative<std::nullptr_t>(mass(grains[1])));
  CHECK(std::get<Measured>(mass(grains[0])).value == 2);
  CHECK(Column<Grain>("m", "", mass).has_error); // nothing has two cells as well
}

TEST_CASE("how values are shown") {
  CHECK(shown_text({.heading = "", .digits = 3}, 0.123456, screen_sign) == "0.123");
  CHECK(shown_text({.heading = "", .digits = 1, .unit = 0.01, .symbol = " %"}, 0.5, screen_sign) ==
        "5e+01 %");
  CHECK(shown_text({.heading = "", .dimension = Dimension::force}, 66.95e-3, screen_sign) == "66.95 mN");
  CHECK(shown_text({.heading = "", .digits = 2, .fixed = true, .sign = true}, 1.5, screen_sign) == "+1.50");
  CHECK(shown_text({.heading = "", .digits = 2}, std::vector<double>{1, 2.5}, screen_sign) == "1 2.5");
  CHECK(shown_text({.heading = "", .digits = 2, .symbol = " %"}, std::vector<double>{1, 2.5}, screen_sign) ==
        "1 % 2.5 %");
  CHECK(cell_text({.heading = "", .width = 3, .digits = 6}, 123456.0) ==
        " 123456"); // apart from the one before
  CHECK(cell_text({.heading = "", .width = 3}, 12.0) == " 12");
  CHECK(heading_text({.heading = "a long heading", .width = 3}) == "a long heading");
}

TEST_CASE("the columns of a part are included in those of the whole") {
  struct Pair {
    const Grain* first;
    const Grain* second;
  };
  Columns<Pair> all;
  add_part(
      all, columns, [](const Pair& pair) { return pair.second; }, "second/", "second_");
  CHECK(all[1].heading == "second_R_m");
  CHECK(all[1].key == "second/radius");
  CHECK(all[2].key.empty());
  CHECK(csv_text(all, std::vector<Pair>{{nullptr, &grains[0]}, {nullptr, nullptr}}) ==
        "second_name,second_R_m,second_m_kg,second_m_kg_error,second_contacts\nlarge,0.5,2,0.5,6\n,,,,\n");
}

TEST_CASE("a list of numbers is refused as a cell") {
  const Columns<Grain> bad{{"list", "", [](const Grain&) { return std::vector<double>{1, 2}; }}};
  CHECK_THROWS_AS((void)csv_text(bad, grains), InvalidArgument);
}
