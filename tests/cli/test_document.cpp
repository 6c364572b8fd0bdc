// SPDX-License-Identifier: GPL-3.0-or-later
// One small document, and what each printer makes of it.
#include "cli/document/document.hpp"

#include "unit.hpp"

namespace {

using namespace granum::cli;

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

struct Pair {
  const char* name;
  double stiffness;
};

RangeRow row(const char* symbol, Seen seen, std::optional<estimate::Range> range) {
  return {.key = symbol,
          .symbol = symbol,
          .heading = symbol,
          .meaning = "meaning of it",
          .dimension = Dimension::pressure,
          .seen = seen,
          .range = range};
}

Document example() {
  Document to{.command = "example", .title = "An example", .question = "What is it?"};
  Items inputs{.key = "inputs", .title = "given"};
  io::add_item(inputs.items, "void_ratio", 0.6, shown_as("e"));
  io::add_item(inputs.items, "depth/top", 2.0);
  inputs.items.emplace_back("e", "", [](const io::Only&) { return io::Value(0.6); });
  to.add(Seen::full, std::move(inputs));
  const estimate::Range G{.value = 1e8, .low = 9e7, .high = 1.2e9};
  to.add(Seen::full, Ranges{.key = "sand",
                            .title = "sand",
                            .before = "sand_",
                            .rows = {row("K", Seen::full, G), row("G", Seen::always, G)}});
  to.add(Seen::full,
         Ranges{.key = "answer",
                .title = "beads",
                .rows = {row("G", Seen::always, G), row("K", Seen::full, G), row("E", Seen::data, {})}});
  to.add(Seen::data, Ranges{.key = "nothing"});
  const io::Columns<Pair> columns = {
      {"", "", &Pair::name},
      {"", "stiffness", &Pair::stiffness, shown_as("stiffness", Dimension::pressure, 12)}};
  const std::vector<Pair> pairs = {{"first_one", 1e6}, {"second", 2e6}};
  to.add(Seen::always, table_of("named", "by name", columns, pairs, Table::Form::named));
  to.add(Seen::full, table_of("", "side by side", columns, pairs, Table::Form::columns));
  to.add(Seen::data, table_of("list", "", columns, pairs));
  to.add(Seen::first, Prose{{"for a start"}});
  to.add(Seen::data, Data{"inputs", {{"more", 3}}});
  const auto note = [](estimate::Note what, Seen seen) { return Note{std::move(what), seen}; };
  to.notes = {note({.reason = "a note [Lo2021]"}, Seen::full),
              note({.name = "--mean-radius",
                    .value = "500 um",
                    .number = 5e-4,
                    .deviation = 1e-4,
                    .dimension = Dimension::length,
                    .reason = "as usual"},
                   Seen::full),
              note({.reason = "for files"}, Seen::data)};
  return to;
}

} // namespace

TEST_CASE("document: the first screen has the answers side by side, and what is always seen") {
  const std::string text = screen(example(), false);
  CHECK(text == "An example\n"
                "        sand                               beads\n"
                "  G     100 MPa (90 MPa to 1.2 GPa)        100 MPa (90 MPa to 1.2 GPa)\n"
                "\n"
                "by name\n"
                "     stiffness\n"
                "         1 MPa\n"
                "         2 MPa\n"
                "\n"
                "  for a start\n");
}

TEST_CASE("document: the full screen has all but what is for files") {
  const std::string text = screen(example(), true);
  for (const char* part :
       {"An example\n\ngiven\n  e  0.6\n", "sand\n              answer", "beads\n",
        "  K          100 MPa      90 MPa     1.2 GPa  meaning of it\n",
        "side by side\n                first one  second\n  stiffness         1 MPa   2 MPa\n",
        "\n- a note [Lo2021]\n"})
    CHECK_MESSAGE(has(text, part), part, " is missing in\n", text);
  for (const char* part : {"for a start", "for files", "  E "})
    CHECK_FALSE(has(text, part));
}

TEST_CASE("document: JSON has every section with a key, and null for what does not exist") {
  const nlohmann::ordered_json all = json(example());
  CHECK(all.at("command") == "example");
  CHECK(all.at("inputs") ==
        nlohmann::ordered_json{{"void_ratio", 0.6}, {"depth", {{"top", 2.0}}}, {"more", 3}});
  CHECK(all.at("sand").at("G").at("high") == 1.2e9);
  CHECK(all.at("answer").at("E").is_null());
  CHECK(all.at("nothing").is_null());
  CHECK(all.at("named").at("first_one").at("stiffness") == 1e6);
  CHECK(all.at("first_one").at("stiffness") == 1e6);
  CHECK(all.at("list").at(1).at("stiffness") == 2e6);
  CHECK(all.at("notes").size() == 3);
  CHECK(all.at("notes").at(2) == "for files");
  CHECK(all.at("assumed") ==
        nlohmann::ordered_json{
            {"mean_radius", {{"value", 5e-4}, {"deviation", 1e-4}, {"reason", "as usual"}}}});
}

TEST_CASE("document: CSV has one row of values, or the rows of a table that has headings") {
  Document document = example();
  CHECK(has(csv(document), "\ne,G_answer_Pa,G_low_Pa,G_high_Pa,K_answer_Pa,"));
  CHECK(has(csv(document), ",sand_G_high_Pa\n0.6"));
  CHECK(has(csv(document), "# note: a note [Lo2021]\n"));
  CHECK_FALSE(has(csv(document), "for files"));
  document.add(Seen::data, table_of("", "", io::Columns<Pair>{{"stiffness_Pa", "", &Pair::stiffness}},
                                    std::vector<Pair>{{"", 1e6}, {"", 2e6}}));
  CHECK(has(csv(document), "\nstiffness_Pa\n1000000\n2000000\n"));
}

TEST_CASE("document: the page has answers, tables, notes and their sources") {
  Document document = example();
  document.warnings.add("beware");
  const std::string text = page(document);
  for (const char* part :
       {"What is it?", "100 MPa (90 MPa to 1.2 GPa).", "first one", "a note [<a href=\"#Lo2021\">Lo2021</a>]",
        "<td id=\"Lo2021\">", "beware", "<pre>An example"})
    CHECK_MESSAGE(has(text, part), part, " is missing");
  for (const char* part : {"for files", ", granum 0."})
    CHECK_FALSE(has(text, part));
}

TEST_CASE("document: an assumed input is a row with value, deviation and reason") {
  const std::string text = page(example());
  CHECK(has(text, "<td class=\"number\">500 um</td>\n<td class=\"number\">100 um</td>\n<td>as usual</td>"));
}

TEST_CASE("document: the page of a run has its date, its version and what was asked") {
  Document document = example();
  document.question.clear();
  const std::string text =
      page(document, {.date = "1 May 2026", .asked = {{"--void-ratio", "0.6", "Void ratio, instead of n"}}});
  for (const char* part : {"<h1>An example</h1>", "1 May 2026, granum 0.", "<td>Void ratio</td>",
                           "<td class=\"number\">0.6</td>\n<td>--void-ratio</td>"})
    CHECK_MESSAGE(has(text, part), part, " is missing");
}

TEST_CASE("document: the page has the decimal sign of the table, but for what was typed") {
  Document document = example();
  document.manner = {.separator = ';', .decimal_sign = ','};
  const std::string text = page(document, {.date = "", .asked = {{"--void-ratio", "0.6", "e"}}});
  CHECK(has(text, "(90 MPa to 1,2 GPa)"));
  CHECK(has(text, "<td class=\"number\">0.6</td>\n<td>--void-ratio</td>"));
  CHECK(has(text, "Engineering 147(5), 04021020."));
}

TEST_CASE("document: a picture is asked for where there is one") {
  Document document = example();
  CHECK_THROWS_AS((void)picture(document), InvalidArgument);
  document.add(Seen::data, Picture{{{.title = "a chart"}}, "what it shows"});
  CHECK(has(picture(document), "a chart"));
  document.sentences = {"the answer in words"};
  document.add(Seen::data, Picture{{}, "another", "<svg>drawn</svg>", {"rose.csv"}});
  const std::string text = page(document);
  for (const char* part : {"what it shows", "the answer in words", "another", "<svg>drawn</svg>", "rose.csv"})
    CHECK(has(text, part));
}
