// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <granum/io/csv/table.hpp>

#include "number_columns.hpp"
#include "packing_options.hpp"

/// Packings from the rows of a table, completed by the options of a command.
namespace granum::cli {

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
