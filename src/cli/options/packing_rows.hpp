// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <granum/io/csv/table.hpp>

#include "packing_options.hpp"

/// Packings that stand in the rows of a table, with the options of a command for what it does not hold.
namespace granum::cli {

/// The inputs that a table holds, by the names of their options, void_ratio, or by symbol, e; and the packing
/// of each of its rows.
class PackingRows {
 public:
  /// \throws   FileError for an input without its unit or with two; InvalidArgument for one that stands under
  ///           both of its names, or that an option gives too
  PackingRows(const io::CsvTable& table, const PackingOptions& options);
  PackingRows(const PackingRows&) = delete; // holds places within itself
  PackingRows& operator=(const PackingRows&) = delete;

  /// The packing of a row.
  /// \throws   InvalidArgument
  const PackingOptions& packing(std::size_t row);

  /// Says that a column is read by someone else.
  void mark_as_read(std::size_t column) { read_.at(column) = true; }
  /// Headings of the columns that say nothing to this program.
  [[nodiscard]] std::vector<std::string> unread() const;

 private:
  struct Input {
    Number* number;
    io::CsvTable::Column column;
  };

  void bind(Number& number, const io::CsvTable::Column& column);
  [[nodiscard]] bool always_needed(const Number& number) const;
  void take(const Input& input, const std::string& field) const;

  const io::CsvTable& table_;
  PackingOptions row_;
  std::vector<Input> inputs_;
  std::optional<std::size_t> contact_;
  std::vector<bool> read_;
};

} // namespace granum::cli
