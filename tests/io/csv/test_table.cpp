// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/csv/table.hpp>

#include <fstream>

#include "io/temporary_folder.hpp"
#include "unit.hpp"

using namespace granum::io;

namespace {

/// The message with which reading one column of the text fails; empty if it does not.
std::string table_refusal(std::string_view text, std::string_view quantity = "G",
                          Dimension dimension = Dimension::pressure) {
  try {
    (void)CsvTable("a.csv", text).numbers(quantity, dimension);
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST_CASE("columns are found by name and come in as SI") {
  const CsvTable table("a.csv",
                       "# made by hand\nG_MPa, sigma_v_kPa,e\n\n120,100,0.56\r\n# half way\n150.5,200,0.55");
  CHECK(table.row_count() == 2);
  CHECK(table.numbers("G", Dimension::pressure) == std::vector<double>{120e6, 150.5e6});
  CHECK(table.numbers("sigma_v", Dimension::pressure) == std::vector<double>{1e5, 2e5});
  CHECK(table.numbers("e", Dimension::dimensionless) == std::vector<double>{0.56, 0.55});
  CHECK(table.line(0) == 4);
  CHECK(table.line(1) == 6);
  CHECK(table.has("sigma_v"));
  CHECK_FALSE(table.has("sigma"));
}

TEST_CASE("a row is available as text, with the place and the factor of each quantity") {
  const CsvTable table("a.csv", "name,G_MPa,e\n\"a, b\",120,dense\n");
  CHECK(table.fields(0) == std::vector<std::string>{"a, b", "120", "dense"});
  CHECK(table.column("G", Dimension::pressure).index == 1);
  CHECK(table.column("G", Dimension::pressure).factor == 1e6);
  CHECK(table.column("e", Dimension::dimensionless).factor == 1);
  CHECK_THROWS_AS((void)table.column("G", Dimension::length), FileError);
  CHECK_THROWS_AS((void)table.column("K", Dimension::pressure), FileError);
  CHECK(csv_line({"a, b", 120.5, std::numeric_limits<double>::quiet_NaN(), ""}) == "\"a, b\",120.5,,\n");
}

TEST_CASE("quotes, byte order mark and lines inside quotes") {
  const CsvTable table("a.csv", "\xEF\xBB\xBF\"name\",G_Pa\n\"one, \"\"two\"\"\n\",1\n \"x\" ,2\n");
  CHECK(table.headings() == std::vector<std::string>{"name", "G_Pa"});
  CHECK(table.numbers("G", Dimension::pressure) == std::vector<double>{1, 2});
  CHECK(table.line(1) == 4);
  CHECK(table_refusal("G_Pa\n\"1\n2\n").starts_with("a.csv:2:"));
  CHECK(table_refusal("G_Pa\n\"1\"2\n").starts_with("a.csv:2:"));
}

TEST_CASE("lines may end as on an old Macintosh") {
  const CsvTable table("t.csv", "# by hand\rp_kPa,e\r100,0.6\r\r200,0.7\r");
  CHECK(table.numbers("p", Dimension::pressure) == std::vector{1e5, 2e5});
  CHECK(table.line(1) == 5);
  CHECK(CsvTable("t.csv", "e,p_kPa\r0.6,100\r0.7,200\n").row_count() == 2); // as TextSource ends it
}

TEST_CASE("a bad file is refused with path, line and expectation") {
  const auto refused_at = [](const std::string& place, const std::vector<std::string>& texts) {
    for (const std::string& text : texts) {
      CAPTURE(text);
      CHECK(table_refusal(text).starts_with(place));
    }
  };
  refused_at("a.csv:", {"", "# only a comment\n\n", std::string("G_Pa\n\0\n", 7)});
  refused_at("a.csv:1:", {"G_MPa,e\n", "G,e\n1,2\n", "G_mm,e\n1,2\n", "p_kPa,e\n1,2\n"});
  refused_at("a.csv:1:", {"G_Pa,G_kPa\n1,2\n", "G_Pa,G_Pa\n1,2\n"});
  refused_at("a.csv:2:", {"G_MPa,e\n1,0.5,\n", "G_MPa,e\nabc,0.5\n", "G_MPa,e\n,1\n", "G_GPa\n1e305\n"});
  refused_at("a.csv:3:", {"G_MPa,e\n1,0.5\n2\n", "G_MPa\n1\nnan\n"});
}

TEST_CASE("written values are read back to the same bits") {
  const std::vector<double> values{1. / 3, -0.0, 6.02e23, std::numeric_limits<double>::denorm_min(), 1e-300};
  CsvContent content{
      .notes = {{"version", "0.1.0\nsecond line"}}, .headings = {"text, with comma", "p_Pa"}, .rows = {}};
  for (const double value : values)
    content.rows.push_back({std::string("#a \"b\""), value});
  const TemporaryFolder folder;
  CHECK_THROWS_AS((void)read_csv(folder.path()), FileError);
  std::ofstream(folder.path() / "t.csv", std::ios::binary) << csv_text(content);
  const CsvTable table = read_csv(folder.path() / "t.csv");
  CHECK(table.headings() == content.headings);
  CHECK(table.numbers("p", Dimension::pressure) == values);
}

TEST_CASE("the text of a file") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(csv_text({.notes = {{"seed", "1"}},
                  .headings = {"a", "error"},
                  .rows = {{0.5, std::string("")}, {nan, std::string("x,y")}}}) ==
        "# seed: 1\na,error\n0.5,\n,\"x,y\"\n");
  CHECK_THROWS_AS((void)csv_text({.notes = {}, .headings = {"a"}, .rows = {{1.0, 2.0}}}), InvalidArgument);
}

TEST_CASE("semicolons separate the fields of spreadsheets that write decimal commas, with mark and CRLF") {
  const io::CsvTable table("a.csv",
                           "\xEF\xBB\xBFsample;e;p [kPa]\r\n\"one; two\";0,65;1e2\r\nthree, four;0.7;200\r\n"
                           "1,2,3;+,5;-1,5e1\r\n");
  CHECK(table.headings() == std::vector<std::string>{"sample", "e", "p [kPa]"});
  CHECK(table.numbers("e", Dimension::dimensionless) == std::vector<double>{0.65, 0.7, 0.5});
  CHECK(table.numbers("p", Dimension::pressure) == std::vector<double>{100e3, 200e3, -15e3});
  CHECK(table.fields(0)[0] == "one; two");
  CHECK(table.fields(1)[0] == "three, four");
  CHECK(table.fields(2)[0] == "1,2,3");
}

TEST_CASE("a table is written in the manner of another one, and read back to the bit") {
  const io::CsvTable commas("a.csv", "name;e\ndense;0,65\n"), points("b.csv", "name;e\ndense;0.65\n"),
      usual("c.csv", "name,e\ndense,0.65\n");
  CHECK(io::csv_line({commas.fields(0)[0], commas.fields(0)[1], 1.5, "a;b, 1.5"}, commas.manner()) ==
        "dense;0,65;1,5;\"a;b, 1.5\"\n");
  CHECK(io::csv_line({"0.65", 1.5}, points.manner()) == "0.65;1.5\n");
  CHECK(io::csv_line({"0.65", 1.5}, usual.manner()) == "0.65,1.5\n");
  const double value = 0.1234567890123456;
  const std::string text = io::csv_text({.notes = {{"note", "1.5"}},
                                         .headings = {"e", "p_kPa"},
                                         .rows = {{value, 1e-7}},
                                         .manner = commas.manner()});
  CHECK(text.starts_with("# note: 1.5\ne;p_kPa\n"));
  CHECK(io::CsvTable("d.csv", text).numbers("e", Dimension::dimensionless).front() == value); // to the bit
}

TEST_CASE("commas that could be either are refused with path and line") {
  for (const char* text : {"# note\ne,x;p_kPa\n1;2\n", "e,p_kPa\n0,65,100,5\n", "e;p_kPa\n\"1\" 2;3\n"})
    CHECK(table_refusal(text).starts_with("a.csv:2:"));
  CHECK(io::CsvTable("a.csv", "\"e, x\";p_kPa\n1;2\n").headings()[0] == "e, x");
}

TEST_CASE("a mark that may separate thousands is refused if it is not the decimal mark of other numbers") {
  struct Rows {
    char point, other, separator;
  };
  for (const Rows& rows : {Rows{',', '.', ';'}, {'.', ',', ';'}, {'.', ',', '\t'}}) {
    const auto table = [&](std::string text) { // written with decimal commas, and points that separate
      for (char& c : text)
        c = c == ',' ? rows.point : c == '.' ? rows.other : c == ';' ? rows.separator : c;
      return text;
    };
    for (const char* number : {"1.500", "-12.000", "+999.999", "\"1.500\""}) {
      const std::string last = std::string("0,6;") + number + "\n";
      const std::string said = table_refusal(table("e;p_kPa\n1;2\n0,7;2\n" + last), "p");
      CAPTURE(said);
      CHECK(said.starts_with("a.csv:4: "));
      CHECK(said.find("'p_kPa'") != std::string::npos);
      CHECK(table_refusal(table("e;p_kPa\n2,500;2\n" + last), "p").starts_with("a.csv:"));
    }
    for (const char* number :
         {"0.650", "1.5", "1.50", "1.5000", "1000.500", "1.5e3", "12,000", "a.500", ".500"})
      CHECK(CsvTable("a.csv", table(std::string("e;name\n0,6;") + number + "\n")).row_count() == 1);
  }
  CHECK(CsvTable("a.csv", "e;p_kPa\n0,6;1,500\n").numbers("p", Dimension::pressure) == std::vector{1500.0});
  CHECK(table_refusal("e;p_kPa\n0.7;1.500\n0.6;2\n", "p").empty());                    // no commas at all
  CHECK(table_refusal("e;p_kPa\n2.500;2\n0.6;1,500\n", "p").starts_with("a.csv:2: ")); // either could be
  CHECK(CsvTable("a.csv", "e;name\n0.6;1,500,000\n").row_count() == 1);
}

TEST_CASE("no written text is a formula to a spreadsheet, and each is read back unchanged") {
  for (const std::string text :
       {"=1+1", "@SUM(A1)", "+1+cmd", "-2+3", "'=x", "''-x", "-1.5 kPa", "+-", "=a,b", "=\"x\""}) {
    const std::string line = csv_line({text, 1.0});
    CHECK(std::string_view("=+-@").find(line[line[0] == '"' ? 1 : 0]) == std::string_view::npos);
    const CsvTable table("a.csv", csv_text({.notes = {}, .headings = {text, "b"}, .rows = {{text, 1.0}}}));
    CHECK(table.headings()[0] == text);
    CHECK(table.fields(0)[0] == text);
  }
  for (const std::string text : {"-1.5", "+5", "-", "'", "'a", "a=b", "1e-3"}) {
    CHECK(csv_line({text}) == text + "\n");
    CHECK(CsvTable("a.csv", "x\n" + text + "\n").fields(0)[0] == text);
  }
  CHECK(csv_line({-1.5}) == "-1.5\n");
  CHECK(csv_text({.notes = {{"file", "a\r=x\n=y"}}, .headings = {"a"}, .rows = {}}) ==
        "# file: a =x =y\na\n");
}
