// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/csv/sieve.hpp>

#include <algorithm>
#include <optional>

#include <granum/core/error.hpp>

namespace granum::io {

std::vector<sizes::SievePoint> sieve_curve(const CsvTable& table) {
  const std::vector<double> diameters = table.numbers("d", Dimension::length);
  const std::vector<double> passing = table.numbers("passing", Dimension::dimensionless);
  std::vector<sizes::SievePoint> curve;
  for (std::size_t row = 0; row < diameters.size(); ++row)
    curve.push_back({.diameter = diameters[row], .passing = passing[row]});
  const bool descends = curve.front().diameter > curve.back().diameter;
  if (descends)
    std::reverse(curve.begin(), curve.end());
  if (const auto fault = sizes::find_fault(curve)) {
    const std::size_t row = descends ? curve.size() - 1 - fault->point : fault->point;
    throw FileError(table.name(), table.line(row), "sieve curve: " + fault->what);
  }
  return curve;
}

std::vector<sizes::SievePoint> read_sieve_curve(const std::filesystem::path& path) {
  return sieve_curve(read_csv(path));
}

} // namespace granum::io
