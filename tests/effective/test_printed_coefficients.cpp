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

std::vector<std::string> cells(const std::string& row) {
  std::vector<std::string> out;
  std::istringstream in(row.substr(1));
  for (std::string cell; std::getline(in, cell, '|');) {
    std::erase(cell, ' ');
    out.push_back(cell);
  }
  return out;
}

double number(const std::string& text) {
  const auto value = parse_number(text);
  REQUIRE_MESSAGE(value.has_value(), text);
  return *value;
}

/// A printed number is this one, to half of its last digit.
void check_printed(const std::string& text, double value) {
  CAPTURE(text);
  const std::size_t point = text.find('.');
  const double digits = point == std::string::npos ? 0 : static_cast<double>(text.size() - point - 1);
  CHECK(std::abs(number(text) - value) <= 0.5 * std::pow(10, -digits) * (1 + 1e-9));
}

/// The row `below` lines under the first line of docs/theory.md that begins so.
std::vector<std::string> row_under(std::string_view beginning, std::size_t below) {
  std::ifstream file(GRANUM_THEORY_PAGE);
  REQUIRE_MESSAGE(file, GRANUM_THEORY_PAGE);
  std::string line;
  while (std::getline(file, line) && !line.starts_with(beginning)) {
  }
  REQUIRE_MESSAGE(line.starts_with(beginning), beginning);
  for (; below > 0; --below)
    std::getline(file, line);
  return cells(line);
}

template <class Coefficients>
void check_row(std::string_view heading, const Coefficients& coefficients) {
  const std::vector<std::string> row = row_under(heading, 2);
  REQUIRE(row.size() == coefficients.size());
  for (std::size_t k = 0; k < row.size(); ++k)
    check_printed(row[k], coefficients[k]);
}

} // namespace

TEST_CASE(
    "docs/theory.md prints the coefficients of the present fit, and the factors that follow from them") {
  check_row("| $c_1$", effective::kernel::shear_coefficients);
  check_row("| $k_1$", effective::kernel::bulk_coefficients);
  std::vector<double> rolling(effective::kernel::rolling_shear.begin(),
                              effective::kernel::rolling_shear.end());
  rolling.insert(rolling.end(), effective::kernel::rolling_bulk.begin(),
                 effective::kernel::rolling_bulk.end());
  check_row("| $a_1$", rolling);
  const std::vector<std::string> z = row_under("| $z^*$ | 4.2", 0), shear = row_under("| $z^*$ | 4.2", 2),
                                 bulk = row_under("| $z^*$ | 4.2", 3);
  REQUIRE((z.size() > 2 && shear.size() == z.size() && bulk.size() == z.size()));
  for (std::size_t k = 1; k < z.size(); ++k) {
    const effective::Relaxation factors = effective::relaxation(number(z[k]), 0.919, 1.0 / 3);
    check_printed(shear[k], factors.shear.value);
    check_printed(bulk[k], factors.bulk.value);
  }
}
