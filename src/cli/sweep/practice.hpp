// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <variant>

#include <granum/io/csv/columns.hpp>

/// Tables in units of practice: stresses in kPa, moduli in MPa, five digits.
/// Checked by tests/cli/rows/units.txt
namespace granum::cli {

/// A heading in a unit of practice, and the factor to its numbers.
struct PracticeHeading {
  std::string heading;
  double factor = 1;
};
/// "G_answer_MPa" for "G_answer_Pa", "p_kPa" for "p_Pa"; others as they are.
[[nodiscard]] PracticeHeading practice_heading(const std::string& heading);
/// A number with five digits; also one that is not finite, as it is.
[[nodiscard]] double practice_number(double number);

/// The columns of a CSV file in units of practice; their JSON is not asked for then.
template <class Row>
void to_practice(io::Columns<Row>& columns) {
  for (io::Column<Row>& column : columns) {
    const auto [heading, factor] = practice_heading(column.heading);
    column.heading = heading;
    column.of = [of = column.of, factor = factor](const Row& row) {
      io::Value value = of(row);
      if (double* number = std::get_if<double>(&value))
        *number = practice_number(*number * factor);
      return value;
    };
  }
}

} // namespace granum::cli
