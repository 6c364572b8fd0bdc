// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/plot/chart.hpp>

#include <algorithm>
#include <cmath>

#include <granum/core/check.hpp>
#include <granum/core/error.hpp>
#include <granum/core/number.hpp>
#include <granum/plot/svg_text.hpp>

#include "chart_parts.hpp"
#include "ticks.hpp"

namespace granum::plot {

namespace {

constexpr double left = 96;
constexpr double top = 48;
constexpr double bottom = 66;
constexpr double right_without_legend = 28;
constexpr double font_size = 14;
constexpr double glyph_width = 0.62 * font_size; // a wide estimate of a letter, for the legend's width
constexpr double legend_line = 22;
constexpr double legend_margin = 14; // of one below the plot, and between its names
constexpr double legend_sample = 42; // line and marker in front of a name

/// Colours that people with colour blindness tell apart, after Okabe and Ito.
constexpr const char* colours[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"};
constexpr const char* dashes[] = {"", "8 4", "2 3", "10 3 2 3"};
constexpr std::size_t dash_count = std::size(dashes);
constexpr std::size_t shape_count = 4;

struct Point {
  double x = 0;
  double y = 0;
};

std::string pair(const Point& p) { return svg_number(p.x) + "," + svg_number(p.y); }

/// How a series looks.
class Look {
 public:
  Look(const Series& series, std::size_t place) : index_(series.style.value_or(place)), tone_(series.tone) {}

  [[nodiscard]] double marker_size() const { return tone_ == Tone::faint ? 2.5 : 4; }
  [[nodiscard]] const char* colour() const { return tone_ == Tone::grey ? grey : series_colour(index_); }
  [[nodiscard]] std::size_t shape() const { return index_ % shape_count; }

  [[nodiscard]] SvgAttributes stroke() const {
    const bool thin = tone_ == Tone::faint || tone_ == Tone::grey;
    SvgAttributes attributes = {{"fill", "none"}, {"stroke", colour()}, {"stroke-width", thin ? "1.3" : "2"}};
    const char* dash = dashes[index_ % dash_count];
    if (*dash != '\0')
      attributes.emplace_back("stroke-dasharray", dash);
    return attributes;
  }
  [[nodiscard]] SvgAttributes surface() const {
    return {{"class", "area"}, {"fill", colour()}, {"fill-opacity", "0.18"}};
  }
  [[nodiscard]] SvgAttributes filling() const {
    if (tone_ == Tone::hollow)
      return {{"fill", "white"}, {"stroke", colour()}, {"stroke-width", "1.5"}};
    return {{"fill", colour()}};
  }
  [[nodiscard]] SvgAttributes group() const {
    SvgAttributes attributes = {{"class", "series"}};
    if (tone_ == Tone::faint)
      attributes.emplace_back("opacity", "0.55");
    return attributes;
  }

 private:
  std::size_t index_;
  Tone tone_;
};

/// A circle, square, diamond or triangle.
std::string marker(const Look& look, const Point& p) {
  const double s = look.marker_size();
  switch (look.shape()) {
  case 0:
    return svg_element("circle", {{"cx", svg_number(p.x)}, {"cy", svg_number(p.y)}, {"r", svg_number(s)}});
  case 1:
    return svg_element("rect", {{"x", svg_number(p.x - s)},
                                {"y", svg_number(p.y - s)},
                                {"width", svg_number(2 * s)},
                                {"height", svg_number(2 * s)}});
  case 2:
    return svg_element("path",
                       {{"d", "M" + pair({p.x, p.y - 1.4 * s}) + "L" + pair({p.x + 1.4 * s, p.y}) + "L" +
                                  pair({p.x, p.y + 1.4 * s}) + "L" + pair({p.x - 1.4 * s, p.y}) + "Z"}});
  default:
    return svg_element("path",
                       {{"d", "M" + pair({p.x, p.y - 1.3 * s}) + "L" + pair({p.x + 1.2 * s, p.y + 0.9 * s}) +
                                  "L" + pair({p.x - 1.2 * s, p.y + 0.9 * s}) + "Z"}});
  }
}

std::string label_content(const Tick& tick) {
  if (tick.power.empty())
    return svg_escaped(tick.mantissa);
  return svg_escaped(tick.mantissa) + "10<tspan dy=\"-5\" font-size=\"10\">" + svg_escaped(tick.power) +
         "</tspan>";
}

/// The points of a series that can be drawn, in the units of the axes.
class DrawnSeries {
 public:
  DrawnSeries(const Chart& chart, const Series& series) {
    for (std::size_t k = 0; k < series.x.size(); ++k) {
      const Point p{series.x[k] / chart.x.unit, series.y[k] / chart.y.unit};
      if (AxisRange::drawable(chart.x.scale, p.x) && AxisRange::drawable(chart.y.scale, p.y)) {
        points.push_back(p);
        joined.push_back(!gap && !joined.empty());
        const double error = series.y_error.empty() ? 0 : std::abs(series.y_error[k] / chart.y.unit);
        errors.push_back(std::isfinite(error) ? error : 0);
        gap = false;
      } else {
        gap = true;
      }
    }
  }

  std::vector<Point> points;
  std::vector<bool> joined; ///< by a line with the point before
  std::vector<double> errors;

 private:
  bool gap = false;
};

class Picture {
 public:
  explicit Picture(const Chart& chart)
      : chart_(chart), drawn_(drawn(chart)), x_(chart.x.scale, values(chart.x.scale, false)),
        y_(chart.y.scale, values(chart.y.scale, true)) {}

  [[nodiscard]] double width() const { return left + chart_.width + right(); }
  [[nodiscard]] double height() const { return top + chart_.height + bottom + legend_height(); }

  /// Title, axes, curves and legend.
  [[nodiscard]] std::string content() const {
    std::string svg = svg_text("title",
                               {{"x", svg_number(left + chart_.width / 2)},
                                {"y", svg_number(top - 18)},
                                {"text-anchor", "middle"},
                                {"font-size", "16"}},
                               svg_escaped(chart_.title));
    svg += x_axis() + y_axis() + frame();
    for (std::size_t k = 0; k < drawn_.size(); ++k)
      svg += curve(k);
    return svg + legend();
  }

 private:
  static std::vector<DrawnSeries> drawn(const Chart& chart) {
    std::vector<DrawnSeries> all;
    for (const Series& series : chart.series)
      all.emplace_back(chart, series);
    return all;
  }

  [[nodiscard]] std::vector<double> values(Scale scale, bool vertical) const {
    std::vector<double> found;
    for (const DrawnSeries& series : drawn_)
      for (std::size_t k = 0; k < series.points.size(); ++k) {
        const double value = vertical ? series.points[k].y : series.points[k].x;
        found.push_back(value);
        if (vertical)
          for (const double end : {value - series.errors[k], value + series.errors[k]})
            if (AxisRange::drawable(scale, end))
              found.push_back(end);
      }
    return found;
  }

  [[nodiscard]] double at_x(double x) const {
    const double share = x_.fraction(x);
    return left + chart_.width * (chart_.x.reversed ? 1 - share : share);
  }
  [[nodiscard]] double at_y(double y) const {
    const double share = y_.fraction(y);
    return top + chart_.height * (chart_.y.reversed ? share : 1 - share);
  }
  [[nodiscard]] Point place(const Point& p) const { return {at_x(p.x), at_y(p.y)}; }

  [[nodiscard]] std::string x_axis() const {
    std::string svg;
    for (const Tick& tick : x_.ticks()) {
      const double x = at_x(tick.value);
      svg += grid_line({x, top}, {x, top + chart_.height}, tick);
      svg +=
          svg_line({x, top + chart_.height}, {x, top + chart_.height + (tick.labelled() ? 6 : 3)}, "black");
      if (tick.labelled())
        svg += svg_text(
            "x-label",
            {{"x", svg_number(x)}, {"y", svg_number(top + chart_.height + 22)}, {"text-anchor", "middle"}},
            label_content(tick));
    }
    return svg + svg_text("x-title",
                          {{"x", svg_number(left + chart_.width / 2)},
                           {"y", svg_number(top + chart_.height + 50)},
                           {"text-anchor", "middle"}},
                          svg_escaped(chart_.x.title));
  }

  [[nodiscard]] std::string y_axis() const {
    std::string svg;
    for (const Tick& tick : y_.ticks()) {
      const double y = at_y(tick.value);
      svg += grid_line({left, y}, {left + chart_.width, y}, tick);
      svg += svg_line({left - (tick.labelled() ? 6 : 3), y}, {left, y}, "black");
      if (tick.labelled())
        svg += svg_text("y-label",
                        {{"x", svg_number(left - 10)}, {"y", svg_number(y + 5)}, {"text-anchor", "end"}},
                        label_content(tick));
    }
    const std::string middle = svg_number(top + chart_.height / 2);
    return svg + svg_text("y-title",
                          {{"x", "24"},
                           {"y", middle},
                           {"text-anchor", "middle"},
                           {"transform", "rotate(-90 24 " + middle + ")"}},
                          svg_escaped(chart_.y.title));
  }

  [[nodiscard]] static std::string svg_line(const Point& from, const Point& to, const char* colour) {
    return svg_element("line", {{"x1", svg_number(from.x)},
                                {"y1", svg_number(from.y)},
                                {"x2", svg_number(to.x)},
                                {"y2", svg_number(to.y)},
                                {"stroke", colour}});
  }

  [[nodiscard]] static std::string grid_line(const Point& from, const Point& to, const Tick& tick) {
    return tick.labelled() ? svg_line(from, to, "#e3e3e3") : "";
  }

  [[nodiscard]] std::string frame() const {
    return svg_element("rect", {{"x", svg_number(left)},
                                {"y", svg_number(top)},
                                {"width", svg_number(chart_.width)},
                                {"height", svg_number(chart_.height)},
                                {"fill", "none"},
                                {"stroke", "black"}});
  }

  [[nodiscard]] std::string error_bar(const Point& p, double error, double cap) const {
    const double x = at_x(p.x);
    const auto end = [this](double y, double edge) {
      return AxisRange::drawable(chart_.y.scale, y) ? at_y(y) : edge;
    };
    const double upper = top, lower = top + chart_.height;
    const double high = end(p.y + error, chart_.y.reversed ? lower : upper);
    const double low = end(p.y - error, chart_.y.reversed ? upper : lower);
    return svg_element(
        "path", {{"class", "error"},
                 {"d", "M" + pair({x - cap, high}) + "H" + svg_number(x + cap) + "M" + pair({x, high}) + "V" +
                           svg_number(low) + "M" + pair({x - cap, low}) + "H" + svg_number(x + cap)}});
  }

  [[nodiscard]] std::string curve(std::size_t index) const {
    const DrawnSeries& series = drawn_[index];
    const Mark mark = chart_.series[index].mark;
    const Look look(chart_.series[index], index);
    std::string path;
    std::string dots;
    std::string bars;
    for (std::size_t k = 0; k < series.points.size(); ++k) {
      const Point p = place(series.points[k]);
      path += (series.joined[k] ? "L" : "M") + pair(p);
      dots += marker(look, p);
      if (series.errors[k] > 0)
        bars += error_bar(series.points[k], series.errors[k], look.marker_size());
    }
    if (mark == Mark::area)
      return svg_group({{"class", "series"}}, path.empty() ? "" : surface(look, path + "Z"));
    std::string svg;
    if (mark != Mark::marker && !path.empty()) {
      SvgAttributes attributes = look.stroke();
      attributes.emplace_back("d", path);
      svg += svg_element("path", attributes);
    }
    svg += svg_group({{"fill", "none"}, {"stroke", look.colour()}}, bars);
    if (mark != Mark::line)
      svg += svg_group(look.filling(), dots);
    return svg_group(look.group(), svg);
  }

  [[nodiscard]] static std::string surface(const Look& look, const std::string& path) {
    SvgAttributes attributes = look.surface();
    attributes.emplace_back("d", path);
    return svg_element("path", attributes);
  }

  [[nodiscard]] std::string legend() const {
    const std::vector<Point> places = legend_places();
    std::string svg;
    for (std::size_t k = 0; k < chart_.series.size(); ++k)
      if (!chart_.series[k].name.empty())
        svg += legend_entry(k, places[k]);
    return svg;
  }

  [[nodiscard]] std::string legend_entry(std::size_t k, const Point& at) const {
    const Series& series = chart_.series[k];
    const Look look(series, k);
    std::string svg;
    if (series.mark == Mark::area)
      svg += surface(look, "M" + pair({at.x, at.y - 6}) + "h34v12h-34Z");
    if (series.mark == Mark::line || series.mark == Mark::both) {
      SvgAttributes attributes = look.stroke();
      attributes.emplace_back("d", "M" + pair(at) + "H" + svg_number(at.x + 34));
      svg += svg_element("path", attributes);
    }
    if (series.mark == Mark::marker || series.mark == Mark::both)
      svg += svg_group(look.filling(), marker(look, {at.x + 17, at.y}));
    return svg + svg_text("legend", {{"x", svg_number(at.x + legend_sample)}, {"y", svg_number(at.y + 5)}},
                          svg_escaped(series.name));
  }

  /// Of every series, also of those that are not listed: right of the plot one below the other, or under it
  /// from left to right, as many in a row as there is room for.
  [[nodiscard]] std::vector<Point> legend_places() const {
    std::vector<Point> places;
    Point next = chart_.legend_below ? Point{legend_margin, top + chart_.height + bottom + 4}
                                     : Point{left + chart_.width + 20, top + 12};
    const double end = left + chart_.width + right_without_legend - legend_margin;
    for (const Series& series : chart_.series) {
      const double length = legend_sample + name_width(series);
      if (chart_.legend_below && next.x > legend_margin && next.x + length > end)
        next = {legend_margin, next.y + legend_line};
      places.push_back(next);
      if (series.name.empty())
        continue;
      if (chart_.legend_below)
        next.x += length + legend_margin;
      else
        next.y += legend_line;
    }
    return places;
  }

  [[nodiscard]] static double name_width(const Series& series) {
    return glyph_width * static_cast<double>(series.name.size());
  }

  [[nodiscard]] double legend_height() const {
    double lowest = 0;
    if (chart_.legend_below && !chart_.series.empty())
      lowest = legend_places().back().y - (top + chart_.height + bottom) + legend_line - 8;
    return lowest;
  }

  [[nodiscard]] double right() const {
    double longest = 0;
    for (const Series& series : chart_.series)
      longest = std::max(longest, name_width(series));
    return longest == 0 || chart_.legend_below ? right_without_legend : 76 + longest;
  }

  const Chart& chart_;
  std::vector<DrawnSeries> drawn_;
  AxisRange x_;
  AxisRange y_;
};

} // namespace

const char* series_colour(std::size_t index) { return colours[index % std::size(colours)]; }

void require_valid(const Chart& chart) {
  require_positive("unit of the x axis", chart.x.unit);
  require_positive("unit of the y axis", chart.y.unit);
  require_positive("width of a plot", chart.width);
  require_positive("height of a plot", chart.height);
  for (const Series& series : chart.series)
    if (series.y.size() != series.x.size() ||
        (!series.y_error.empty() && series.y_error.size() != series.x.size()))
      throw InvalidArgument("series '" + series.name + "' has " + std::to_string(series.x.size()) + " x, " +
                            std::to_string(series.y.size()) + " y and " +
                            std::to_string(series.y_error.size()) + " errors of y");
}

std::string svg(const Chart& chart) { return svg(std::span(&chart, 1)); }

std::string svg(std::span<const Chart> charts) {
  if (charts.empty())
    throw InvalidArgument("a picture needs a chart");
  double width = 0, height = 0;
  std::string content;
  for (const Chart& chart : charts) {
    require_valid(chart);
    const Picture picture(chart);
    const std::string shift = "translate(" + svg_number(width) + " 0)";
    content += charts.size() == 1 ? picture.content() : svg_group({{"transform", shift}}, picture.content());
    width += picture.width();
    height = std::max(height, picture.height());
  }
  const std::string w = svg_number(width), h = svg_number(height);
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" +
         w + "\" height=\"" + h + "\" viewBox=\"0 0 " + w + " " + h +
         "\" font-family=\"Helvetica, Arial, sans-serif\" font-size=\"" + svg_number(font_size) + "\">\n" +
         svg_element("rect", {{"width", "100%"}, {"height", "100%"}, {"fill", "white"}}) + content +
         "</svg>\n";
}

} // namespace granum::plot
