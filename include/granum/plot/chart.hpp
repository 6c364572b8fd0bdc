// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <granum/plot/palette.hpp>

/// Pictures of results: y over x, lines and markers, as SVG text that needs nothing from outside.
/// Checked by tests/plot/test_chart.cpp
namespace granum::plot {

enum class Scale { linear, logarithmic };

struct Axis {
  std::string title = {}; ///< with its unit: "p' [kPa]"
  Scale scale = Scale::linear;
  double unit = 1;       ///< > 0, what the numbers are divided by: 1e3 for Pa shown in kPa
  bool reversed = false; ///< the smallest number right, or on top: depth grows downwards
  /// Of the x axis: numbers, as those of the series, that have a tick with a label before round ones do.
  std::vector<double> asked = {};
};

enum class Mark {
  line,
  marker,
  both,
  area ///< the points are corners of a surface, which is filled pale and without an outline
};

enum class Tone {
  full,
  faint, ///< thin, half transparent, with small markers: what is behind the others
  grey,  ///< thin and without a colour of its own
  hollow ///< markers without filling
};

/// One curve. A point with a coordinate that cannot be drawn (NaN, infinite, or below 1e-290 on a logarithmic
/// axis) is left out, and the line has a gap there.
struct Series {
  std::string name = {}; ///< in the legend; empty: not listed there
  Mark mark = Mark::both;
  std::vector<double> x = {};
  std::vector<double> y = {};
  std::vector<double> y_error = {}; ///< half lengths of error bars, one a point, or empty; NaN or 0: no bar
  /// Dashes and marker, and the colour unless that is said; without: the place in the chart. Series of one
  /// style look alike.
  std::optional<std::size_t> style = {};
  Tone tone = Tone::full;
  std::optional<Colour> colour = {}; ///< what the series is
  /// What several series of different colours are, such as "cyclic shear": listed once, in grey.
  std::string kind = {};

  /// A point, in the second form with the half length of its error bar.
  void add(double at, double value) {
    x.push_back(at);
    y.push_back(value);
  }
  void add(double at, double value, double error) {
    add(at, value);
    y_error.push_back(error);
  }
};

/// A right triangle that shows a power: y grows from y0 as x^slope between x0 and x1.
struct SlopeTriangle {
  double x0 = 0; ///< in the units of the series, as y0
  double x1 = 0;
  double y0 = 0;
  double slope = 0;
  std::string text;                  ///< beside it; texts of triangles that end at one x keep apart
  std::optional<Colour> colour = {}; ///< as that of a series; without: that of texts
};

struct Chart {
  std::string title = {}; ///< UTF-8, as all texts
  Axis x = {};
  Axis y = {};
  std::vector<Series> series = {};
  double width = 520; ///< of the plot itself, without titles and legend; the letters are 14 high
  double height = 380;
  bool legend_below = false; ///< under the plot; else right of it, one name a line
  /// What a reader sees in it, for those who cannot; empty: where each series goes, in numbers.
  std::string finding = {};
  std::vector<SlopeTriangle> triangles = {};
  /// Whether x are angles from the vertical, 0 to pi/2 [rad], and y distances from the centre of a rose, the
  /// same in all four quadrants. Series of markers alone become bars as wide as their steps, those of both
  /// markers and lines become markers. Errors are in the upper right quadrant.
  bool rose = false;
};

/// The picture as an SVG file of its own: same chart, same bytes. Ranges follow from the points; without any
/// the axes are drawn alone. Named lines without error bars that lie on each other, point by point within
/// 1.5 pixels, are drawn once, and the legend says "A, B: one curve".
/// \throws   InvalidArgument if a series has other numbers of x, y and (unless empty) y_error, or a unit,
///           the width or the height is not positive
[[nodiscard]] std::string svg(const Chart& chart);

/// Several charts in one SVG file, side by side from the left.
/// \param    in_a_row   >= 1, as many are side by side, and the next below them
/// \throws   InvalidArgument as above, without a chart, or for none in a row
[[nodiscard]] std::string svg(std::span<const Chart> charts, std::size_t in_a_row = SIZE_MAX);

/// One chart as a part of a page of html_page (plot/page.hpp), which has the rules for dark screens.
[[nodiscard]] std::string svg_in_page(const Chart& chart);

} // namespace granum::plot
