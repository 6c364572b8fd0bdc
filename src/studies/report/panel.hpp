// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <granum/plot/chart.hpp>

/// Charts of reports, with the files that their numbers go to.
/// Checked by tests/cli/test_figures.cpp
namespace granum::studies {

/// One chart, and how its numbers are called in a CSV file.
struct Panel {
  std::string stem; ///< of its files: "fig09_cone_dense_G_hv_p"
  plot::Chart chart;
  std::string x_heading; ///< with the unit of the chart's numbers: "p_Pa"
  std::string y_heading;
  std::vector<std::string> keys; ///< one for each series, which the names of its columns begin with
};

/// An axis and the heading of its numbers.
struct Quantity {
  std::string heading;
  plot::Axis axis;
};

/// A small chart without series, to be placed beside others.
[[nodiscard]] Panel panel(std::string stem, std::string title, const Quantity& x, const Quantity& y);

/// Adds a series, unless it has no points.
void add(Panel& to, plot::Series series, std::string key);

/// The numbers of a panel, two or three columns (x, y, error of y) for each series.
[[nodiscard]] std::string panel_csv(const Panel& panel);

} // namespace granum::studies
