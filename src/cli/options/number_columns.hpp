// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <granum/io/csv/table.hpp>

#include "packing_options.hpp"

/// Columns of a table with values that are options elsewhere.
namespace granum::cli {

/// Numbers bound to their columns, by the names of their options (void_ratio, "void ratio") or
/// by symbol (e), with their unit: p_kPa, "p (kPa)", "p [kPa]".
class NumberColumns {
 public:
  explicit NumberColumns(const io::CsvTable& table);

  /// Binds the number if the table has a column of it; whether it has. Where a row leaves it empty the number
  /// is not given, and has its default.
  /// \throws   FileError for a column without its unit, or if two contain the number;
  ///           InvalidArgument where an option gives it too
  bool bind(Number& number);
  /// The column of a text with that heading; none if there is none.
  /// \throws   InvalidArgument where an option gives it too
  [[nodiscard]] std::optional<std::size_t> text(const std::string& heading, bool option_given);
  /// Says that a column is read by someone else.
  void mark_as_read(std::size_t column) { read_.at(column) = true; }

  /// Sets the bound numbers to those of a row.
  /// \throws   InvalidArgument for a field that is no number
  void take(std::size_t row) const;
  /// Headings of unused columns.
  [[nodiscard]] std::vector<std::string> unread() const;

 private:
  struct Input {
    Number* number;
    io::CsvTable::Place column;
    double by_default;
  };

  const io::CsvTable& table_;
  std::vector<Input> inputs_;
  std::vector<bool> read_;
};

} // namespace granum::cli
