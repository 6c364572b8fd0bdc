// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the records of validation programs.
#pragma once

#include <limits>
#include <map>
#include <string>
#include <vector>

#include <granum/io/csv/table.hpp>

/// One row: texts, and numbers in the unit of their heading, by the headings.
class Entry {
 public:
  Entry(const std::vector<std::string>& headings, const std::vector<std::string>& fields) {
    for (std::size_t k = 0; k < headings.size(); ++k)
      fields_[headings[k]] = fields[k];
  }
  [[nodiscard]] bool has(const std::string& heading) const { return fields_.count(heading) > 0; }
  [[nodiscard]] const std::string& text(const std::string& heading) const { return fields_.at(heading); }
  /// Not a number where the field is empty.
  [[nodiscard]] double operator()(const std::string& heading) const {
    const std::string& field = text(heading);
    return field.empty() ? std::numeric_limits<double>::quiet_NaN() : std::stod(field);
  }

 private:
  std::map<std::string, std::string> fields_;
};

inline std::vector<Entry> read_record(const std::string& path) {
  const granum::io::CsvTable table = granum::io::read_csv(path);
  std::vector<Entry> entries;
  for (std::size_t k = 0; k < table.row_count(); ++k)
    entries.emplace_back(table.headings(), table.fields(k));
  return entries;
}
