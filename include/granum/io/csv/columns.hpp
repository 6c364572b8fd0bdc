// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <granum/io/csv/table.hpp>
#include <granum/io/csv/value.hpp>

/// A result as one list of columns: CSV, JSON, a table on a screen, a list on a screen and a table of a page
/// are prints of it. An additional result is one more entry.
/// Checked by tests/io/csv/test_columns.cpp
namespace granum::io {

template <class Row>
struct Column {
  std::string heading;                 ///< in CSV, with its unit; empty: not there
  std::string key;                     ///< in JSON, "probes/G_hh_Pa" within an object; empty: not there
  std::function<Value(const Row&)> of; ///< in SI
  std::optional<ShownColumn> shown;    ///< empty: neither in the terminal nor in a page
  bool has_error = false;              ///< Measured: CSV has a second column, heading_error

  /// \param    get   a member, or a function of a row: a number, a count, a truth, a text, a Measured,
  ///                 numbers, or an optional one of these
  template <class Get>
  Column(std::string heading_, std::string key_, Get get, std::optional<ShownColumn> shown_ = {})
      : heading(std::move(heading_)), key(std::move(key_)),
        of([get](const Row& row) { return value_of(std::invoke(get, row)); }), shown(std::move(shown_)),
        has_error(gives_measured<Get, Row>) {}
};

template <class Row>
using Columns = std::vector<Column<Row>>;

/// A result of one row, each value at its key. JSON: members(items, Only{}); screen: list_text(items,
/// Only{}).
struct Only {};
using Items = Columns<Only>;
template <class T>
void add_item(Items& to, std::string key, const T& value, std::optional<ShownColumn> shown = {}) {
  to.emplace_back(
      "", std::move(key), [value = value_of(value)](const Only&) { return value; }, std::move(shown));
}

/// Adds the columns of a part of a row, which `part_of` finds; null where a row has none.
/// \param    key, heading   prefixes of each key and of each heading that is not empty
template <class Row, class Part, class PartOf>
void add_part(Columns<Row>& to, const Columns<Part>& columns, PartOf part_of, const std::string& key = "",
              const std::string& heading = "") {
  for (Column<Part> column : columns) {
    const auto of = [part_of, get = column.of](const Row& row) {
      const Part* part = part_of(row);
      return part == nullptr ? Value() : get(*part);
    };
    to.emplace_back(column.heading.empty() ? "" : heading + column.heading,
                    column.key.empty() ? "" : key + column.key, of, column.shown);
    to.back().has_error = column.has_error;
  }
}

template <class Row>
void add_headings(CsvContent& to, const Columns<Row>& columns) {
  for (const Column<Row>& column : columns) {
    if (column.heading.empty())
      continue;
    to.headings.push_back(column.heading);
    if (column.has_error)
      to.headings.push_back(column.heading + "_error");
  }
}

/// The headings alone.
template <class Row>
[[nodiscard]] std::vector<std::string> headings_of(const Columns<Row>& columns) {
  CsvContent csv;
  add_headings(csv, columns);
  return csv.headings;
}

/// Adds a value as a cell, or two where it has an error.
/// \throws   InvalidArgument for several numbers, which are no cell
void add_cell(std::vector<CsvCell>& to, const Value& value, bool has_error);

template <class Row>
void add_cells(std::vector<CsvCell>& to, const Columns<Row>& columns, const Row& row) {
  for (const Column<Row>& column : columns)
    if (!column.heading.empty())
      add_cell(to, column.of(row), column.has_error);
}

/// The text of a file with a row for each of `rows`, below the notes.
template <class Row>
[[nodiscard]] std::string csv_text(const Columns<Row>& columns, const std::vector<Row>& rows,
                                   std::vector<std::pair<std::string, std::string>> notes = {}) {
  CsvContent csv{.notes = std::move(notes), .headings = {}, .rows = {}};
  add_headings(csv, columns);
  for (const Row& row : rows)
    add_cells(csv.rows.emplace_back(), columns, row);
  return csv_text(csv);
}

/// The lines of a table on a screen, without their ends and blanks there.
template <class Row>
[[nodiscard]] std::string heading_line(const Columns<Row>& columns) {
  std::string line;
  for (const Column<Row>& column : columns)
    if (column.shown && column.shown->width != 0)
      line += heading_text(*column.shown);
  line.erase(line.find_last_not_of(' ') + 1);
  return line;
}
template <class Row>
[[nodiscard]] std::string row_line(const Columns<Row>& columns, const Row& row) {
  std::string line;
  for (const Column<Row>& column : columns)
    if (column.shown && column.shown->width != 0) {
      const std::string cell = cell_text(*column.shown, column.of(row));
      const bool set_off = line.empty() && column.shown->width > 0 &&
                           cell.size() > static_cast<std::size_t>(column.shown->width); // from nothing
      line += set_off ? cell.substr(1) : cell;
    }
  line.erase(line.find_last_not_of(' ') + 1);
  return line;
}
/// The whole table, each line with its end.
template <class Row>
[[nodiscard]] std::string table_text(const Columns<Row>& columns, const std::vector<Row>& rows) {
  std::string text = heading_line(columns) + "\n";
  for (const Row& row : rows)
    text += row_line(columns, row) + "\n";
  return text;
}

/// The values of a row, one line each, for the terminal.
template <class Row>
[[nodiscard]] std::string list_text(const Columns<Row>& columns, const Row& row, int label_width = 24) {
  std::string text;
  for (const Column<Row>& column : columns)
    if (column.shown && column.shown->listed)
      if (const Value value = column.of(row); !is_nothing(value))
        text += list_line(*column.shown, value, label_width);
  return text;
}

/// A table of a page (plot/page.hpp): the columns that a table on a screen has, with their meanings below.
[[nodiscard]] std::string page_table(const std::vector<ShownColumn>& columns,
                                     const std::vector<std::vector<Value>>& rows);
template <class Row>
[[nodiscard]] std::string page_table(const Columns<Row>& columns, const std::vector<Row>& rows) {
  std::vector<ShownColumn> shown;
  std::vector<std::vector<Value>> values(rows.size());
  for (const Column<Row>& column : columns)
    if (column.shown && column.shown->width != 0) {
      shown.push_back(*column.shown);
      for (std::size_t k = 0; k < rows.size(); ++k)
        values[k].push_back(column.of(rows[k]));
    }
  return page_table(shown, values);
}

} // namespace granum::io
