// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of a finished study, as written by trade_csv.
#include <algorithm>
#include <array>

#include <granum/core/error.hpp>
#include <granum/core/number.hpp>
#include <granum/io/csv/table.hpp>

#include "trade_report.hpp"

namespace granum::cli {

std::vector<studies::TradeRow> read_trade_rows(const std::filesystem::path& csv) {
  constexpr std::array boundaries{studies::Boundary::periodic, studies::Boundary::smooth_walls,
                                  studies::Boundary::rough_walls};
  constexpr std::array densities{triaxial::Density::dense, triaxial::Density::loose};
  const io::CsvTable table = io::read_csv(csv);
  std::vector<studies::TradeRow> rows;
  for (std::size_t k = 0; k < table.row_count(); ++k) {
    const auto text = [&](const std::string& heading) {
      const auto found = std::find(table.headings().begin(), table.headings().end(), heading);
      if (found == table.headings().end())
        throw FileError(table.name(), table.heading_line(), "has no column " + heading);
      return table.fields(k)[static_cast<std::size_t>(found - table.headings().begin())];
    };
    const auto refused = [&](const std::string& heading) {
      return FileError(table.name(), table.line(k),
                       "column " + heading + " contains '" + text(heading) +
                           "', which is not written by trade");
    };
    const auto number_or_nothing = [&](const std::string& heading) {
      const std::optional<double> number = parse_number(text(heading));
      if (!number && !text(heading).empty())
        throw refused(heading);
      return number;
    };
    const auto number = [&](const std::string& heading) {
      if (const std::optional<double> given = number_or_nothing(heading))
        return *given;
      throw refused(heading);
    };
    const auto named = [&](const std::string& heading, const auto& all) {
      for (const auto value : all)
        if (studies::name(value) == text(heading))
          return value;
      throw refused(heading);
    };
    const auto deviation = [&](const std::string& of) -> std::optional<studies::Deviation> {
      const std::optional<double> bias = number_or_nothing(of + "_bias");
      if (!bias)
        return std::nullopt;
      return studies::Deviation{*bias, number(of + "_error"), number(of + "_scatter")};
    };
    rows.push_back({.varied = named("varied", studies::all_varied),
                    .boundary = named("boundary", boundaries),
                    .value = number("value"),
                    .density = named("density", densities),
                    .specimens = static_cast<std::size_t>(number("specimens")),
                    .reference = number("reference") != 0,
                    .shear_modulus = deviation("G"),
                    .exponent = deviation("s"),
                    .peak_ratio = deviation("peak"),
                    .cpu_seconds = number_or_nothing("cpu_s").value_or(0),
                    .steps = number_or_nothing("steps").value_or(0)});
  }
  return rows;
}

} // namespace granum::cli
