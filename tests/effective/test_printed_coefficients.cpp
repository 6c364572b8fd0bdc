// SPDX-License-Identifier: GPL-3.0-or-later
// What docs/theory.md prints of the calibration of rung 3 is what the code holds.
#include <granum/effective/relaxation.hpp>

#include <fstream>
#include <sstream>

#include <granum/core/text.hpp>

#include "effective/relaxation_coefficients.hpp"
#include "effective/rolling_coefficients.hpp"
#include "unit.hpp"

namespace {

/// A number and half of the last digit that is printed of it.
struct Printed {
  double value;
  double half_digit;
};

std::vector<std::string> theory_lines() {
  std::ifstream file(GRANUM_THEORY_PAGE);
  REQUIRE_MESSAGE(file, GRANUM_THEORY_PAGE);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);)
    lines.push_back(line);
  return lines;
}

std::vector<std::string> cells(const std::string& row) {
  std::vector<std::string> out;
  std::istringstream in(row.substr(1));
  for (std::string cell; std::getline(in, cell, '|');) {
    std::string trimmed;
    for (const char c : cell)
      if (c != ' ')
        trimmed += c;
    out.push_back(trimmed);
  }
  return out;
}

Printed printed(const std::string& text) {
  const std::size_t point = text.find('.');
  const int digits = point == std::string::npos ? 0 : static_cast<int>(text.size() - point - 1);
  const auto value = parse_number(text);
  REQUIRE_MESSAGE(value.has_value(), text);
  return {*value, 0.5 * std::pow(10.0, -digits)};
}

/// The row `below` lines under the first line that begins so.
std::vector<std::string> row_under(std::string_view beginning, std::size_t below) {
  const std::vector<std::string> lines = theory_lines();
  for (std::size_t k = 0; k + below < lines.size(); ++k)
    if (lines[k].starts_with(beginning))
      return cells(lines[k + below]);
  FAIL("docs/theory.md has no line that begins with " << beginning);
  return {};
}

template <class Coefficients>
void check_row(std::string_view heading, const Coefficients& coefficients) {
  const std::vector<std::string> row = row_under(heading, 2);
  REQUIRE(row.size() == coefficients.size());
  for (std::size_t k = 0; k < row.size(); ++k) {
    CAPTURE(row[k]);
    const Printed number = printed(row[k]);
    CHECK(std::abs(number.value - coefficients[k]) <= number.half_digit * (1 + 1e-9));
  }
}

} // namespace

TEST_CASE("docs/theory.md prints the coefficients of the present fit") {
  check_row("| $c_1$", effective::kernel::shear_coefficients);
  check_row("| $k_1$", effective::kernel::bulk_coefficients);
  std::vector<double> rolling(effective::kernel::rolling_shear.begin(),
                              effective::kernel::rolling_shear.end());
  rolling.insert(rolling.end(), effective::kernel::rolling_bulk.begin(),
                 effective::kernel::rolling_bulk.end());
  check_row("| $a_1$", rolling);
}

TEST_CASE("docs/theory.md prints the factors that follow from them") {
  const std::vector<std::string> z = row_under("| $z^*$ | 4.2", 0);
  const std::vector<std::string> shear = row_under("| $z^*$ | 4.2", 2);
  const std::vector<std::string> bulk = row_under("| $z^*$ | 4.2", 3);
  REQUIRE(z.size() > 2);
  REQUIRE(shear.size() == z.size());
  REQUIRE(bulk.size() == z.size());
  for (std::size_t k = 1; k < z.size(); ++k) {
    CAPTURE(z[k]);
    const effective::Relaxation factors = effective::relaxation(printed(z[k]).value, 0.919, 1.0 / 3);
    const Printed of_shear = printed(shear[k]), of_bulk = printed(bulk[k]);
    CHECK(std::abs(of_shear.value - factors.shear.value) <= of_shear.half_digit);
    CHECK(std::abs(of_bulk.value - factors.bulk.value) <= of_bulk.half_digit);
  }
}
