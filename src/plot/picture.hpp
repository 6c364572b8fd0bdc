// SPDX-License-Identifier: GPL-3.0-or-later
// What charts on straight axes and roses share.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include <granum/plot/chart.hpp>

#include "look.hpp"
#include "ticks.hpp"

namespace granum::plot {

/// The points of a series that can be drawn, in the units of the axes.
struct DrawnSeries {
  DrawnSeries(const Chart& chart, const Series& series);

  std::vector<Spot> points;
  std::vector<bool> joined; ///< by a line with the point before
  std::vector<double> errors;
};

/// All that an SVG file holds, but for the file's own head.
struct Canvas {
  double width = 0;
  double height = 0;
  std::vector<std::string> title = {}; ///< line by line, over the middle
  std::string content = {};
  std::string finding = {}; ///< for those who cannot see the picture

  /// Title and content.
  [[nodiscard]] std::string drawn() const;
  /// \param    of_its_own   a whole file, else a part of a page
  [[nodiscard]] std::string text(bool of_its_own) const;
};

[[nodiscard]] std::string svg_grid_line(const Spot& from, const Spot& to);

/// A chart around a centre.
[[nodiscard]] Canvas rose_canvas(const Chart& chart);

} // namespace granum::plot
