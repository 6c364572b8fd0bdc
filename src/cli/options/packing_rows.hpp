// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <granum/io/csv/table.hpp>

#include "packing_options.hpp"

/// Columns of a table for values that may also be options, and packings from its rows, completed by the
/// options of a command.
namespace granum::cli {

/// The names of a column, without the unit: symbols, which blanks separate, then the usual spellings of the
/// option without its hyphens, void_ratio.
[[nodiscard]] std::vector<std::string> names_of_column(Input input);
[[nodiscard]] std::vector<std::string> names_of_column(std::string_view symbols, const std::string& option);

/// Numbers bound to their columns, by the names of their options (void_ratio, "void ratio") or
/// by symbol (e), with their unit: p_kPa, "p (kPa)", "p [kPa]".
class NumberColumns {
 public:
  explicit NumberColumns(const io::CsvTable& table);

  /// Binds the number to its column; returns whether the table has one. If a row leaves it empty, the number
  /// is not given and has its default.
  /// \throws   FileError for a column without its unit, or if two columns contain the number;
  ///           InvalidArgument if it is given by an option too
  bool bind(Number& number);
  /// The column of a text with that heading; empty if there is none.
  /// \throws   InvalidArgument if it is given by an option too
  [[nodiscard]] std::optional<std::size_t> text(const std::string& heading, bool option_given);
  /// Marks a column as used by other code.
  void mark_as_read(std::size_t column) { read_.at(column) = true; }

  /// Sets the bound numbers to those of a row.
  /// \throws   InvalidArgument for a field that is not a number
  void take(std::size_t row) const;
  /// The heading of the column that gives an option, such as "--saturation".
  [[nodiscard]] std::optional<std::string> heading(std::string_view option) const;
  /// Headings of unused columns.
  [[nodiscard]] std::vector<std::string> unread() const;

 private:
  struct Input {
    Number* number;
    io::CsvTable::Place column;
    double by_default;
  };

  void read(std::size_t column, const std::string& option);

  const io::CsvTable& table_;
  std::vector<Input> inputs_;
  std::vector<bool> read_;
  std::vector<std::string> options_; ///< of each column; empty without one
};

/// The inputs in a table: numbers, contact, sizes; and the packing of each of its rows.
class PackingRows {
 public:
  /// \throws   as NumberColumns::bind
  PackingRows(const io::CsvTable& table, const PackingOptions& options);
  PackingRows(const PackingRows&) = delete; // contains pointers into itself
  PackingRows& operator=(const PackingRows&) = delete;

  /// The packing of a row; also sets the numbers bound by other code.
  /// \throws   InvalidArgument
  const PackingOptions& packing(std::size_t row);

  /// Whether options or columns give a stress.
  [[nodiscard]] bool tells_stress() const { return tells_stress_; }

  /// For other columns of the table.
  [[nodiscard]] NumberColumns& columns() { return columns_; }
  [[nodiscard]] const NumberColumns& columns() const { return columns_; }

 private:
  void take_sizes(const std::vector<std::string>& fields);

  const io::CsvTable& table_;
  PackingOptions row_;
  contact::Shape contact_by_default_;
  NumberColumns columns_;
  Number uniformity_;
  std::optional<std::size_t> contact_, sizes_;
  bool sizes_in_table_ = false, tells_stress_ = false;
};

} // namespace granum::cli
