// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/report/panel.hpp"

#include <algorithm>
#include <numeric>

#include <granum/io/csv/columns.hpp>

namespace granum::studies {

Panel panel(std::string stem, std::string title, const Quantity& x, const Quantity& y) {
  return {.stem = std::move(stem),
          .chart = {.title = std::move(title),
                    .x = x.axis,
                    .y = y.axis,
                    .width = 320,
                    .height = 250,
                    .legend_below = true},
          .x_heading = x.heading,
          .y_heading = y.heading,
          .keys = {}};
}

void add(Panel& to, plot::Series series, std::string key) {
  if (series.x.empty())
    return;
  to.chart.series.push_back(std::move(series));
  to.keys.push_back(std::move(key));
}

std::string panel_csv(const Panel& panel) {
  io::Columns<std::size_t> columns; // of the number of a row
  std::size_t rows = 0;
  const auto add_numbers = [&](const std::string& heading, const std::vector<double>& numbers) {
    columns.emplace_back(heading, "", [&numbers](const std::size_t& row) {
      return row < numbers.size() ? std::optional(numbers[row]) : std::nullopt;
    });
    rows = std::max(rows, numbers.size());
  };
  for (std::size_t k = 0; k < panel.keys.size(); ++k) {
    const plot::Series& series = panel.chart.series[k];
    const std::string key = panel.keys[k] + " ";
    add_numbers(key + panel.x_heading, series.x);
    add_numbers(key + panel.y_heading, series.y);
    if (!series.y_error.empty())
      add_numbers(key + "error " + panel.y_heading, series.y_error);
  }
  std::vector<std::size_t> all(rows);
  std::iota(all.begin(), all.end(), std::size_t{0});
  return io::csv_text(columns, all);
}

} // namespace granum::studies
