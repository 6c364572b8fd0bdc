// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <granum/core/text.hpp>

#include "picture.hpp"

namespace granum::plot {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double room = 30; // around the rose, for the names of its axes

/// A chart whose x are angles from the vertical.
class Rose {
 public:
  explicit Rose(const Chart& chart) : chart_(chart), legend_(chart) {
    for (const Series& series : chart.series)
      drawn_.emplace_back(chart, series);
    double most = 0;
    for (const DrawnSeries& series : drawn_)
      for (std::size_t k = 0; k < series.points.size(); ++k)
        most = std::max(most, series.points[k].y + series.errors[k]);
    most_ = most > 0 ? most : 1;
    radius_ = std::min(chart.width, chart.height) / 2;
    width_ = std::max(2 * (radius_ + room), chart.width);
    title_ = wrapped(chart.title, width_ - 16, title_size);
    centre_ = {width_ / 2, 27 + title_line * static_cast<double>(std::max<std::size_t>(1, title_.size())) +
                               room + radius_};
  }

  [[nodiscard]] Canvas canvas() const {
    const double foot = centre_.y + radius_ + room + 26;
    Canvas out{.width = width_, .height = foot, .title = title_, .content = circles() + axes()};
    for (std::size_t k = 0; k < drawn_.size(); ++k)
      out.content += series(k);
    out.content +=
        svg_text("x-title",
                 {{"x", svg_number(centre_.x)}, {"y", svg_number(foot - 14)}, {"text-anchor", "middle"}},
                 svg_escaped(chart_.y.title)) +
        legend_.rows({14, foot + 6}, width_ - 28);
    out.height += legend_.height(width_ - 28) + 4;
    return out;
  }

 private:
  [[nodiscard]] Spot at(double angle, double length) const {
    const double r = radius_ * length / most_;
    return {centre_.x + r * std::sin(angle), centre_.y - r * std::cos(angle)};
  }

  /// The first circle has the meaning of the picture's coordinates for the page's script.
  [[nodiscard]] std::string circles() const {
    std::string svg = svg_element("circle", {{"class", "rose"},
                                             {"cx", svg_number(centre_.x)},
                                             {"cy", svg_number(centre_.y)},
                                             {"r", svg_number(radius_)},
                                             {"fill", "none"},
                                             {"data-most", short_text(most_, 12)}});
    const AxisRange range(Scale::linear, {0, most_});
    for (const Tick& tick : range.ticks())
      if (tick.value > 0 && tick.value <= most_ * 1.001)
        svg += svg_element("circle", {{"class", "grid"},
                                      {"cx", svg_number(centre_.x)},
                                      {"cy", svg_number(centre_.y)},
                                      {"r", svg_number(radius_ * tick.value / most_)},
                                      {"fill", "none"},
                                      {"stroke", "#dfe3e8"}});
    const std::vector<Tick> ticks = range.ticks();
    const auto last = std::find_if(ticks.rbegin(), ticks.rend(),
                                   [this](const Tick& t) { return t.value <= most_ * 1.001 && t.value > 0; });
    if (last == ticks.rend())
      return svg;
    const Spot p = at(3 * pi / 4, last->value);
    return svg + svg_text("y-label", {{"x", svg_number(p.x + 6)}, {"y", svg_number(p.y + 14)}},
                          svg_escaped(last->mantissa + (last->power.empty() ? "" : "10^" + last->power)));
  }

  [[nodiscard]] std::string axes() const {
    std::string svg;
    for (const double angle : {0.0, pi / 2})
      svg += svg_grid_line(at(angle, most_), at(angle + pi, most_));
    const Spot v = at(0, most_), h = at(pi / 2, most_);
    return svg +
           svg_text("x-label",
                    {{"x", svg_number(v.x)}, {"y", svg_number(v.y - 8)}, {"text-anchor", "middle"}}, "v") +
           svg_text("x-label", {{"x", svg_number(h.x + 8)}, {"y", svg_number(h.y + 5)}}, "h");
  }

  /// All directions from the quarter that is given, once around.
  template <class Each>
  static void around(const std::vector<Spot>& quarter, const Each& each) {
    const std::size_t n = quarter.size();
    for (int side = 0; side < 4; ++side)
      for (std::size_t k = 0; k < n; ++k) {
        const std::size_t j = side % 2 == 0 ? k : n - 1 - k;
        const double turn = side < 2 ? 0 : pi;
        each(side % 2 == 0 ? quarter[j].x + turn : pi - quarter[j].x + turn, quarter[j].y, j, side);
      }
  }

  [[nodiscard]] std::string series(std::size_t index) const {
    const DrawnSeries& points = drawn_[index];
    const Look look(chart_.series[index], index);
    if (points.points.empty())
      return "";
    SvgAttributes group = look.group();
    const Mark mark = chart_.series[index].mark;
    if (mark == Mark::line)
      return svg_group(group, outline(points, look));
    group.emplace_back("data-values", values(points));
    return svg_group(group, mark == Mark::marker ? sectors(points) + errors(points)
                                                 : errors(points) + markers(points, look));
  }

  [[nodiscard]] std::string outline(const DrawnSeries& series, const Look& look) const {
    std::string path;
    around(series.points, [&](double angle, double length, std::size_t, int) {
      path += (path.empty() ? "M" : "L") + pair(at(angle, length));
    });
    SvgAttributes attributes = look.stroke();
    attributes.emplace_back("d", path + "Z");
    return svg_element("path", attributes);
  }

  /// Angle, value and error of each point, for the page's script.
  [[nodiscard]] static std::string values(const DrawnSeries& series) {
    std::string out;
    for (std::size_t k = 0; k < series.points.size(); ++k)
      out += (k == 0 ? "" : ";") + short_text(series.points[k].x, 6) + " " +
             short_text(series.points[k].y, 6) + " " + short_text(series.errors[k], 3);
    return out;
  }

  [[nodiscard]] std::string markers(const DrawnSeries& series, const Look& look) const {
    std::string dots;
    around(series.points,
           [&](double angle, double length, std::size_t, int) { dots += look.marker(at(angle, length)); });
    return svg_group(look.filling(), dots);
  }

  [[nodiscard]] std::string sectors(const DrawnSeries& series) const {
    const std::size_t n = series.points.size();
    const double half = n > 1 ? (series.points[1].x - series.points[0].x) / 2 : pi / 4;
    std::string path;
    around(series.points, [&](double angle, double length, std::size_t, int) {
      const std::string r = svg_number(radius_ * length / most_);
      path += "M" + pair(centre_) + "L" + pair(at(angle - half, length)) + "A" + r + "," + r + " 0 0 1 " +
              pair(at(angle + half, length)) + "Z";
    });
    return svg_element("path", {{"class", "sectors"},
                                {"fill", "currentColor"},
                                {"fill-opacity", "0.16"},
                                {"stroke", "currentColor"},
                                {"d", path}});
  }

  /// In the upper right quarter, along the direction.
  [[nodiscard]] std::string errors(const DrawnSeries& series) const {
    std::string bars;
    around(series.points, [&](double angle, double length, std::size_t k, int side) {
      const double error = series.errors[k];
      if (side != 0 || !(error > 0))
        return;
      const Spot low = at(angle, std::max(0.0, length - error)), high = at(angle, length + error);
      const Spot across{4 * std::cos(angle), 4 * std::sin(angle)};
      const auto cap = [&](const Spot& p) {
        return "M" + pair({p.x - across.x, p.y - across.y}) + "L" + pair({p.x + across.x, p.y + across.y});
      };
      bars += svg_element(
          "path", {{"class", "error"}, {"d", cap(low) + "M" + pair(low) + "L" + pair(high) + cap(high)}});
    });
    return svg_group({{"fill", "none"}, {"stroke", "currentColor"}}, bars);
  }

  const Chart& chart_;
  Legend legend_;
  std::vector<DrawnSeries> drawn_;
  double most_ = 1;
  double radius_ = 0;
  double width_ = 0;
  std::vector<std::string> title_;
  Spot centre_;
};

} // namespace

Canvas rose_canvas(const Chart& chart) { return Rose(chart).canvas(); }

} // namespace granum::plot
