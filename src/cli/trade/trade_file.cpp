// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of a finished study, as trade_csv wrote them.
#include <algorithm>
#include <array>

#include <granum/core/error.hpp>
#include <granum/core/number.hpp>
#include <granum/io/csv/table.hpp>

#include "trade_report.hpp"

namespace granum::cli {

namespace {

using studies::Deviation;
using studies::TradeRow;

/// One row of the file by its headings.
class Fields {
 public:
  Fields(const io::CsvTable& table, std::size_t row) : table_(table), row_(row) {}

  [[nodiscard]] const std::string& text(const std::string& heading) const {
    const std::vector<std::string>& headings = table_.headings();
    const auto found = std::find(headings.begin(), headings.end(), heading);
    if (found == headings.end())
      throw FileError(table_.name(), table_.heading_line(), "has no column " + heading);
    return table_.fields(row_)[static_cast<std::size_t>(found - headings.begin())];
  }
  [[nodiscard]] std::optional<double> optional_number(const std::string& heading) const {
    if (text(heading).empty())
      return std::nullopt;
    const std::optional<double> number = parse_number(text(heading));
    if (!number)
      fail(heading);
    return number;
  }
  [[nodiscard]] double number(const std::string& heading) const {
    const std::optional<double> number = optional_number(heading);
    if (!number)
      fail(heading);
    return *number;
  }
  /// The one of all values whose name stands there.
  template <class All>
  [[nodiscard]] auto named(const std::string& heading, const All& all) const {
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const auto value) { return studies::name(value) == text(heading); });
    if (found == all.end())
      fail(heading);
    return *found;
  }
  [[nodiscard]] std::optional<Deviation> deviation(const std::string& quantity) const {
    const std::optional<double> bias = optional_number(quantity + "_bias");
    if (!bias)
      return std::nullopt;
    return Deviation{.bias = *bias,
                     .standard_error = number(quantity + "_error"),
                     .scatter = number(quantity + "_scatter")};
  }

 private:
  [[noreturn]] void fail(const std::string& heading) const {
    throw FileError(table_.name(), table_.line(row_),
                    "column " + heading + " holds '" + text(heading) + "', which trade never writes there");
  }

  const io::CsvTable& table_;
  std::size_t row_;
};

} // namespace

std::vector<TradeRow> read_trade_rows(const std::filesystem::path& csv) {
  constexpr std::array boundaries{studies::Boundary::periodic, studies::Boundary::smooth_walls,
                                  studies::Boundary::rough_walls};
  constexpr std::array densities{triaxial::Density::dense, triaxial::Density::loose};
  const io::CsvTable table = io::read_csv(csv);
  std::vector<TradeRow> rows;
  for (std::size_t k = 0; k < table.row_count(); ++k) {
    const Fields fields(table, k);
    rows.push_back({.varied = fields.named("varied", studies::all_varied),
                    .boundary = fields.named("boundary", boundaries),
                    .value = fields.number("value"),
                    .density = fields.named("density", densities),
                    .specimens = static_cast<std::size_t>(fields.number("specimens")),
                    .reference = fields.number("reference") != 0,
                    .shear_modulus = fields.deviation("G"),
                    .exponent = fields.deviation("s"),
                    .peak_ratio = fields.deviation("peak"),
                    .cpu_seconds = fields.optional_number("cpu_s").value_or(0),
                    .steps = fields.optional_number("steps").value_or(0)});
  }
  return rows;
}

} // namespace granum::cli
