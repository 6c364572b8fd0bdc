// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <granum/io/csv/table.hpp>

/// A table as one list of columns, from which files and screen are written: a new column is one more entry.
/// Checked by tests/io/csv/test_columns.cpp
namespace granum::io {

/// How a column looks on a screen.
struct ShownColumn {
  std::string heading;
  int width = 0;           ///< of heading and numbers, both to the right [characters]
  int digits = 4;          ///< significant ones, or behind the point
  bool fixed = false;      ///< digits behind the point
  double unit = 1;         ///< that numbers are shown in [SI]
  std::string absent = ""; ///< what a row without a number shows
  bool ahead = false;      ///< stands before those that are not, wherever it is in the list
};

enum class ColumnKind {
  number,
  count ///< a whole number, which JSON shows as one
};

template <class Row>
struct Column {
  using Of = std::function<std::optional<double>(const Row&)>;
  using Text = std::function<std::string(const Row&)>;

  std::string heading; ///< in CSV, with its unit; empty: not there
  std::string key;     ///< in JSON, "probes/G_hh_Pa" within an object; empty: not there
  Of of;               ///< the number of a row, SI; nothing: an empty cell
  Text text;           ///< the text of a row, in CSV; null where the column holds numbers
  ColumnKind kind = ColumnKind::number;
  std::optional<ShownColumn> shown; ///< nothing: not on the screen

  Column(std::string heading_, std::string key_, Of of_, ColumnKind kind_ = ColumnKind::number)
      : heading(std::move(heading_)), key(std::move(key_)), of(std::move(of_)), kind(kind_) {}
  Column(std::string heading_, std::string key_, Of of_, ShownColumn shown_)
      : heading(std::move(heading_)), key(std::move(key_)), of(std::move(of_)), kind(ColumnKind::number),
        shown(std::move(shown_)) {}
  /// A column of texts.
  Column(std::string heading_, Text text_)
      : heading(std::move(heading_)), of([](const Row&) { return std::nullopt; }), text(std::move(text_)) {}
};

template <class Row>
using Columns = std::vector<Column<Row>>;

template <class Row>
void add_headings(CsvContent& to, const Columns<Row>& columns) {
  for (const Column<Row>& column : columns)
    if (!column.heading.empty())
      to.headings.push_back(column.heading);
}

template <class Row>
void add_cells(std::vector<CsvCell>& to, const Columns<Row>& columns, const Row& row) {
  for (const Column<Row>& column : columns)
    if (!column.heading.empty())
      to.push_back(column.text ? CsvCell(column.text(row)) : CsvCell(column.of(row).value_or(empty_cell)));
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

/// A heading, or a number in its unit, to the right of the column; what is shown for nothing. A number that
/// fills its column has a blank in front, so that it never runs into the one before.
[[nodiscard]] std::string heading_text(const ShownColumn& column);
[[nodiscard]] std::string number_text(const ShownColumn& column, const std::optional<double>& number);

/// Calls visit(column, how it is shown) for the columns of a screen, from left to right.
template <class Row, class Visit>
void for_each_shown(const Columns<Row>& columns, const Visit& visit) {
  for (const bool ahead : {true, false})
    for (const Column<Row>& column : columns)
      if (column.shown && column.shown->ahead == ahead)
        visit(column, *column.shown);
}

/// The lines of a table on a screen, without their ends and blanks there.
template <class Row>
[[nodiscard]] std::string heading_line(const Columns<Row>& columns) {
  std::string line;
  for_each_shown(columns, [&](const Column<Row>&, const ShownColumn& shown) { line += heading_text(shown); });
  return line;
}
template <class Row>
[[nodiscard]] std::string number_line(const Columns<Row>& columns, const Row& row) {
  std::string line;
  for_each_shown(columns, [&](const Column<Row>& column, const ShownColumn& shown) {
    line += number_text(shown, column.of(row));
  });
  line.erase(line.find_last_not_of(' ') + 1);
  return line;
}

} // namespace granum::io
