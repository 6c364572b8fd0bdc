// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <granum/core/error.hpp>
#include <granum/estimate/answer.hpp>
#include <granum/estimate/notes.hpp>
#include <granum/io/csv/columns.hpp>
#include <granum/plot/chart.hpp>
#include <nlohmann/json.hpp>

#include "cli/frame/command_line.hpp"
#include "cli/frame/frame.hpp"

/// The result of a command as values in sections; each printer below knows how one form of it looks.
/// Checked by tests/cli/test_document.cpp
namespace granum::cli {

/// Where people see a section, a row or a note. JSON and CSV have all of them.
enum class Seen {
  always, ///< also on the first screen
  first,  ///< only on the first screen
  full,   ///< only on the full screen and the page
  data    ///< only in files
};

/// Values by name: a list on a screen, members of an object in JSON, cells of CSV where they have headings.
struct Items {
  std::string key = {}; ///< of their object in JSON, "answer/shares"; empty: that of the document
  std::string title = {};
  io::Items items = {};
};

/// A number with its range; empty where it does not exist, which is null in JSON.
struct RangeRow {
  std::string key, symbol, heading, meaning;
  Dimension dimension = Dimension::dimensionless;
  Seen seen = Seen::full;
  std::optional<estimate::Range> range = {};
};
/// Numbers with their ranges; without any the key is null in JSON. On the first screen all of a document are
/// side by side.
struct Ranges {
  std::string key = {}, title = {};
  std::string before = {}; ///< in front of each heading in CSV
  std::vector<RangeRow> rows = {};
};

using Cells = std::vector<io::Value>;
struct Table {
  /// How rows become lines of a screen and members in JSON.
  enum class Form {
    list,   ///< a line and an element of an array for each
    named,  ///< an object for each, named by the first column
    columns ///< named, and a screen has a column for each
  };
  std::string key = {}, title = {};
  io::Columns<Cells> columns = {};
  std::vector<Cells> rows = {};
  Form form = Form::list;
  std::string remark = {}; ///< below it
  bool folded = false;     ///< on a page, under its title
};
/// Adds a range to items: value, low and high in an object at the key.
void add_range(io::Items& to, const std::string& key, const estimate::Range& range);

/// The values of rows as a table.
template <class Row>
[[nodiscard]] Table table_of(std::string key, std::string title, const io::Columns<Row>& columns,
                             const std::vector<Row>& rows, Table::Form form = Table::Form::list) {
  Table table{.key = std::move(key), .title = std::move(title), .form = form};
  for (std::size_t k = 0; k < columns.size(); ++k) {
    table.columns.emplace_back(
        columns[k].heading, columns[k].key, [k](const Cells& cells) { return cells[k]; }, columns[k].shown);
    table.columns.back().has_error = columns[k].has_error;
  }
  for (const Row& row : rows) {
    Cells& cells = table.rows.emplace_back();
    for (const io::Column<Row>& column : columns)
      cells.push_back(column.of(row));
  }
  return table;
}

/// Charts side by side, with what is to be said of them; the first is beside the answer of a page.
struct Picture {
  std::vector<plot::Chart> charts;
  std::string caption = {}, drawn = {}; ///< `drawn`: SVG of no chart
  std::vector<std::string> files = {};  ///< beside the page, that have its numbers
  std::size_t in_a_row = SIZE_MAX;
  std::vector<std::string> choices = {}; ///< of the charts, where a page shows one choice at a time
  std::string folded = {};               ///< the title under which a page folds it away
};

/// Lines for people, which files do not have.
struct Prose {
  std::vector<std::string> lines;
};

/// Rows printed as they come, because there may be millions: lines of CSV, or elements of an array in JSON.
struct Rows {
  std::string key = {};
  std::vector<std::string> headings = {};
  std::string lines = {};
  nlohmann::ordered_json elements = nlohmann::ordered_json::array();
};

/// What exists as JSON already; in CSV a comment.
struct Data {
  std::string key;
  nlohmann::ordered_json value;
};

struct Section {
  Seen seen;
  std::variant<Items, Ranges, Table, Picture, Prose, Rows, Data> what;
};

/// An assumption or a remark.
struct Note {
  estimate::Note what;
  Seen seen = Seen::full;
};

/// "grain_shear_modulus", the key among the inputs of an assumed one, "--grain-shear-modulus".
[[nodiscard]] std::string input_key(const estimate::Note& note);

struct Document {
  std::string command = {};                ///< "estimate"
  std::string title = {}, question = {};   ///< first line of a screen, and of a page if that has another
  std::vector<std::string> sentences = {}; ///< the answer in words, below that
  std::vector<std::string> sentences_after = {}; ///< below the ranges in words
  std::vector<Section> sections = {};
  std::vector<Note> notes = {};
  Validity warnings = {};
  io::CsvManner manner = {};                                            ///< of the CSV file, as both below
  std::string signs = "compression positive; z is the vertical axis v"; ///< empty: no such comment
  std::vector<std::pair<std::string, std::string>> comments = {};       ///< on its columns
  std::string own_text = {}; ///< in the form of another program, instead of CSV; empty: none

  template <class What>
  void add(Seen seen, What what) {
    sections.push_back({seen, std::move(what)});
  }
  void add_notes(const estimate::Notes& what, Seen seen = Seen::full) {
    for (const estimate::Note& note : what)
      notes.push_back({note, seen});
  }
  void add_notes(const std::vector<std::string>& sentences_of, Seen seen = Seen::full) {
    for (const std::string& sentence : sentences_of)
      notes.push_back({{.reason = sentence}, seen});
  }
};

/// Adds the references that notes and sections cite, for JSON.
void add_sources(Document& to);

// ---- how values look
/// A number in the unit of a screen, with the unit: "118 MPa".
[[nodiscard]] std::string number_text(Dimension dimension, double value);
/// "118 MPa (90.73 to 153.3 MPa)".
[[nodiscard]] std::string range_text(Dimension dimension, const estimate::Range& range);
/// "uniform strain" for "uniform_strain".
[[nodiscard]] std::string with_blanks(std::string key);

/// The look of a value: in a list, or in a table of that width.
[[nodiscard]] inline io::ShownColumn shown_as(std::string label, std::optional<Dimension> dimension = {},
                                              int width = 0) {
  return {.heading = std::move(label), .width = width, .absent = "none", .dimension = dimension};
}
/// That of a share, in per cent.
[[nodiscard]] inline io::ShownColumn shown_as_percent(std::string label, int width = 0) {
  return {
      .heading = std::move(label), .width = width, .digits = 3, .unit = 0.01, .absent = "-", .symbol = " %"};
}

/// What the two ends of a range, or an error, say, in words for a page.
inline constexpr const char
    *what_a_range_means = "From low to high is one standard deviation to each side of the answer: about "
                          "two thirds of such sands or packings lie between, one in six below and one in "
                          "six above.",
    *what_an_error_means = "+- is one standard error: about two thirds of the true values lie within it.";

// ---- printers
/// Text for a terminal, without warnings.
[[nodiscard]] std::string screen(const Document& document, bool full);
/// Every section that has a key, SI units; assumed inputs, and all notes as sentences; without warnings.
[[nodiscard]] nlohmann::ordered_json json(const Document& document);
/// The sections alone, as members of an object.
[[nodiscard]] nlohmann::ordered_json members_of(const std::vector<Section>& sections);
/// Data and notes as comments; then Rows, or the rows of the first table with headings, or else one row of
/// all items with headings and all ranges. A document with a text of its own is that text.
[[nodiscard]] std::string csv(const Document& document);
/// Charts as one SVG file. \throws InvalidArgument if there are none
[[nodiscard]] std::string picture(const Document& document);
/// What the page of one run says besides its document.
struct Record {
  std::string date = {}; ///< "29 November 2026"; empty: none, so that it can be made again
  std::vector<AskedOption> asked = {};
};
/// A page of HTML: answer, picture, what was asked, tables, warnings, assumptions, sources and the full
/// screen. Numbers have the decimal sign of document.manner.
[[nodiscard]] std::string page(const Document& document, const Record& record = {});

/// Where a document is printed to.
struct Outlets {
  OutputOptions output = {};
  std::string picture = {}, report = {}; ///< files; empty for none
  bool full = false;                     ///< the full screen
  bool always_csv = false;               ///< to a file whatever its name, unless it is JSON
  bool csv_on_screen = false;            ///< instead of text

  [[nodiscard]] bool draws() const { return !picture.empty() || !report.empty(); }
};
/// Adds --full, --picture and --report.
void add_outlets(Command& command, Outlets& outlets, const std::string& picture_help);
/// Adds --report, to which --force applies too. Assumes the command has --picture.
void add_report(Command& command, std::string& target);
/// Checks names of files before any work is done.
/// \throws   InvalidArgument for another ending than .svg and .html, and one name for two files; FileError as
///           require_free of frame.hpp
void require_free(const Outlets& outlets);
/// Prints the document wherever it is asked for.
/// \return   as deliver of frame.hpp
ExitCode deliver(const Outlets& outlets, const Document& document);

} // namespace granum::cli
