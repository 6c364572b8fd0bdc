// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/report/panel.hpp"

#include <algorithm>

#include <granum/io/csv/table.hpp>

namespace granum::studies {

namespace {

/// Headings of the columns of a panel.
std::vector<plot::CsvColumns> columns_of(const Panel& panel) {
  std::vector<plot::CsvColumns> out;
  for (std::size_t k = 0; k < panel.keys.size(); ++k) {
    const std::string key = panel.keys[k] + " ";
    const bool errors = !panel.chart.series[k].y_error.empty();
    out.push_back({.x = key + panel.x_heading,
                   .y = key + panel.y_heading,
                   .y_error = errors ? key + "error " + panel.y_heading : ""});
  }
  return out;
}

} // namespace

Panel panel(std::string stem, std::string title, const Quantity& x, const Quantity& y) {
  return {.stem = std::move(stem),
          .chart = {.title = std::move(title),
                    .x = x.axis,
                    .y = y.axis,
                    .series = {},
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
  io::CsvContent csv;
  std::size_t rows = 0;
  const std::vector<plot::CsvColumns> headings = columns_of(panel);
  for (std::size_t k = 0; k < headings.size(); ++k) {
    csv.headings.push_back(headings[k].x);
    csv.headings.push_back(headings[k].y);
    if (!headings[k].y_error.empty())
      csv.headings.push_back(headings[k].y_error);
    rows = std::max(rows, panel.chart.series[k].x.size());
  }
  for (std::size_t row = 0; row < rows; ++row) {
    std::vector<io::CsvCell> cells;
    const auto append = [&](const std::vector<double>& numbers) {
      cells.emplace_back(row < numbers.size() ? numbers[row] : io::empty_cell);
    };
    for (const plot::Series& series : panel.chart.series) {
      append(series.x);
      append(series.y);
      if (!series.y_error.empty())
        append(series.y_error);
    }
    csv.rows.push_back(std::move(cells));
  }
  return io::csv_text(csv);
}

std::string panel_script(const Panel& panel) {
  return plot::gnuplot_script(panel.chart, panel.stem + ".csv", columns_of(panel),
                              panel.stem + "_gnuplot.svg");
}

} // namespace granum::studies
