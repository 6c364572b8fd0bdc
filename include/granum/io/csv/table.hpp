// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <granum/core/units.hpp>
#include <granum/sizes/distribution.hpp>

/// Comma-separated values after RFC 4180: quoted fields, one heading line, units in the headings
/// (sigma_v_kPa). Where semicolons separate the headings they separate all fields, and numbers may have a
/// decimal comma; so do tabs if the headings are not separated by commas or semicolons. A text that a
/// spreadsheet would read as a formula, because it begins with = + - or @ and is not a number, is written
/// after an apostrophe, which is dropped again when it is read. A byte order mark, lines that begin with '#'
/// and blank lines are skipped. Lines end with LF, CR LF, or all with CR.
/// Checked by tests/io/csv/test_table.cpp
namespace granum::io {

/// Separator of the fields and decimal sign of the numbers.
struct CsvManner {
  char separator = ',';
  char decimal_sign = '.'; ///< a comma only where semicolons or tabs separate the fields
};

/// A table that was read. Every row has one field for each heading.
class CsvTable {
 public:
  /// Reads the text of a file; `name` is the path in errors.
  /// \throws   FileError naming the line: no heading, no rows, a row with another number of fields, an
  /// unclosed quote,
  ///           two equal headings, commas and semicolons between them, bytes that are no text, a number
  ///           such as 1.500 where others have decimal commas, or 1,500 where others have decimal points: its
  ///           sign may separate thousands
  CsvTable(std::string name, std::string_view text);

  /// The path in errors.
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] std::size_t row_count() const { return rows_.size(); }
  [[nodiscard]] const std::vector<std::string>& headings() const { return headings_; }
  /// Line of the headings in the file, from 1.
  [[nodiscard]] std::size_t heading_line() const { return heading_line_; }
  /// Line of the file on which a row begins, from 1.
  [[nodiscard]] std::size_t line(std::size_t row) const { return rows_.at(row).line; }

  /// That of the file: a table that follows from it is written alike. The decimal sign is a comma where a
  /// number has one.
  [[nodiscard]] CsvManner manner() const { return manner_; }

  /// The fields of a row as in the file, one for each heading; with points for decimal commas.
  [[nodiscard]] const std::vector<std::string>& fields(std::size_t row) const { return rows_.at(row).fields; }

  /// Whether a column contains `quantity`, with any unit.
  [[nodiscard]] bool has(std::string_view quantity) const;
  /// Column index of a quantity, and the factor from its numbers to SI.
  struct Place {
    std::size_t index = 0;
    double factor = 1;
  };
  /// \throws   FileError if no column or more than one contains the quantity, or if its heading lacks a unit
  ///           of `dimension`
  [[nodiscard]] Place column(std::string_view quantity, Dimension dimension) const;
  /// The column of a quantity in SI: for sigma_v the column sigma_v_kPa, say, times 1000.
  /// \throws   FileError as column, or, naming the line, if a field is not a finite number
  [[nodiscard]] std::vector<double> numbers(std::string_view quantity, Dimension dimension) const;

 private:
  struct Row {
    std::size_t line;
    std::vector<std::string> fields;
  };

  [[nodiscard]] std::size_t find(std::string_view quantity, Dimension dimension) const;

  std::string name_;
  std::size_t heading_line_ = 0;
  std::vector<std::string> headings_;
  std::vector<Row> rows_;
  CsvManner manner_;
};

/// Reads a file whole, plain or gzip.
/// \throws   FileError as file_content or CsvTable
[[nodiscard]] CsvTable read_csv(const std::filesystem::path& path);

/// A number or a text. NaN is written as an empty field, any other number with 17 significant digits.
using CsvCell = std::variant<double, std::string>;
/// The number that makes an empty field.
inline constexpr double empty_cell = std::numeric_limits<double>::quiet_NaN();

/// Content of a CSV file.
struct CsvContent {
  std::vector<std::pair<std::string, std::string>> notes; ///< "# key: value" lines above the heading
  std::vector<std::string> headings;
  std::vector<std::vector<CsvCell>> rows;
  CsvManner manner = {};
};

/// One line of a file, with its end. A text that is a number, as a field of a table that was read, gets the
/// decimal sign too.
[[nodiscard]] std::string csv_line(const std::vector<CsvCell>& cells, CsvManner manner = {});

/// The text of the file; CsvTable reads every finite number back to the same bits.
/// \throws   InvalidArgument if a row has another number of cells than there are headings
[[nodiscard]] std::string csv_text(const CsvContent& content);

/// The sieve curve in a table: a column d with its unit (d_mm) and one of the passing mass, as passing_%
/// or, from 0 to 1, as passing. Rows ascend in d or descend, from or to 0 % and 100 %. Further columns are
/// left alone.
/// \return   points of ascending d, without a fault of sizes::find_fault
/// \throws   FileError naming the line of the point that is at fault, or as CsvTable
/// Checked by tests/io/csv/test_sieve.cpp, tests/fuzz/readers.cpp
[[nodiscard]] std::vector<sizes::SievePoint> sieve_curve(const CsvTable& table);

/// The same of a file.
/// \throws   FileError also if it cannot be read
[[nodiscard]] std::vector<sizes::SievePoint> read_sieve_curve(const std::filesystem::path& path);

} // namespace granum::io
