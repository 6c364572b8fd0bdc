// SPDX-License-Identifier: GPL-3.0-or-later
// What charts on straight axes and roses share: range, ticks and labels of an axis, its frame.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include <granum/plot/chart.hpp>

#include "look.hpp"

namespace granum::plot {

struct Tick {
  double value = 0;
  std::string mantissa; ///< "20", or what precedes the power; both empty: a small tick without label
  std::string power;    ///< exponent of 10, empty without
  [[nodiscard]] bool labelled() const { return !mantissa.empty() || !power.empty(); }
};

/// The part of an axis that a picture shows.
class AxisRange {
 public:
  /// Holds all values, which can be drawn on the scale, with a small margin.
  AxisRange(Scale scale, const std::vector<double>& values);

  /// Whether a value can be drawn on a scale at all.
  [[nodiscard]] static bool drawable(Scale scale, double value);
  /// Place of a value in the range, 0 at its low and 1 at its high end.
  [[nodiscard]] double fraction(double value) const;
  /// Ends of the range: values, or on a logarithmic scale their decimal logarithms.
  [[nodiscard]] double low() const { return low_; }
  [[nodiscard]] double high() const { return high_; }
  /// Ticks within the range, in ascending order; at least two of them carry labels.
  [[nodiscard]] std::vector<Tick> ticks() const;

 private:
  [[nodiscard]] std::vector<Tick> linear_ticks() const;
  [[nodiscard]] std::vector<Tick> logarithmic_ticks() const;

  Scale scale_;
  double low_ = 0; ///< the value, or its decimal logarithm
  double high_ = 1;
};

/// How far apart two points of a picture are at most to be seen as one [pixels]: less than a line is wide.
inline constexpr double one_point = 1.5;

/// The chart with curves that lie on each other drawn once: a named line without error bars whose points
/// are those of an earlier one, each within one_point, loses its points, and the earlier one has all names:
/// "A, B: one curve".
/// Places, and so styles, stay as they are. Markers and surfaces stay: they are data.
/// Checked by tests/plot/test_chart.cpp
[[nodiscard]] Chart with_coinciding_once(Chart chart);

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
