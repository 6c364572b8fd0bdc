// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/plot/chart.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/plot/svg_text.hpp>

#include "look.hpp"
#include "picture.hpp"

namespace granum::plot {

namespace {

constexpr double bottom = 66;
constexpr double least_right = 28;
constexpr double power_size = 11;
constexpr double tick_gap = 8; // least between the labels of an axis

double label_width(const Tick& tick) {
  return text_width(tick.mantissa) +
         (tick.power.empty() ? 0 : text_width("10") + text_width(tick.power, power_size));
}

std::string label_content(const Tick& tick) {
  if (tick.power.empty())
    return svg_escaped(tick.mantissa);
  return svg_escaped(tick.mantissa) + "10<tspan dy=\"-5\" font-size=\"" + svg_number(power_size) + "\">" +
         svg_escaped(tick.power) + "</tspan>";
}

/// A chart on two straight axes.
class Picture {
 public:
  explicit Picture(const Chart& chart)
      : chart_(chart), legend_(chart), drawn_(drawn(chart)), x_(chart.x.scale, values(chart.x.scale, false)),
        y_(chart.y.scale, values(chart.y.scale, true)), x_ticks_(x_.ticks()), y_ticks_(y_.ticks()) {
    if (chart.x.reversed) // from left to right, and from below upwards
      std::reverse(x_ticks_.begin(), x_ticks_.end());
    if (chart.y.reversed)
      std::reverse(y_ticks_.begin(), y_ticks_.end());
    for (const Tick& tick : y_ticks_)
      left_ = std::max(left_, 40 + label_width(tick));
    for (const Tick& tick : x_ticks_)
      right_ = std::max(right_, 4 + label_width(tick) / 2);
    if (!chart.legend_below && legend_.widest() > 0)
      right_ = 20 + legend_.widest() + 8;
    for (const SlopeTriangle& triangle : chart.triangles)
      right_ = std::max(right_, text_width(triangle.text) + 4); // behind the last points, whatever is there
    add_asked_ticks();
    title_ = wrapped(chart.title, left_ + chart.width + right_ - 16, title_size);
    if (!title_.empty())
      top_ = 27 + title_line * static_cast<double>(title_.size());
  }

  [[nodiscard]] Canvas canvas() const {
    const double widest =
        chart_.legend_below ? 28 + legend_.widest() : 0; // a name may be longer than the plot
    const double width = std::max(left_ + chart_.width + right_, widest);
    const double foot = top_ + chart_.height + bottom;
    Canvas out{.width = width, .height = foot, .title = title_, .content = x_axis() + y_axis() + frame()};
    for (std::size_t k = 0; k < drawn_.size(); ++k)
      out.content += curve(k);
    out.content += triangles();
    if (chart_.legend_below) {
      out.content += legend_.rows({14, foot + 4}, width - 28);
      out.height += legend_.height(width - 28);
    } else {
      out.content += legend_.column({left_ + chart_.width + 20, top_ + 12});
      out.height = std::max(out.height, top_ + 24 + legend_.height(0));
    }
    return out;
  }

 private:
  static std::vector<DrawnSeries> drawn(const Chart& chart) {
    std::vector<DrawnSeries> all;
    for (const Series& series : chart.series)
      all.emplace_back(chart, series);
    return all;
  }

  /// A round tick gives its label up to one that was asked for where both would lie upon each other.
  void add_asked_ticks() {
    std::vector<Tick> asked;
    for (const double number : chart_.x.asked) {
      const double value = number / chart_.x.unit;
      if (!AxisRange::drawable(chart_.x.scale, value) || x_.fraction(value) < 0 || x_.fraction(value) > 1)
        continue;
      const Tick tick{value, short_text(value, 4), ""};
      const auto covered = [&](const Tick& other) {
        return std::abs(at_x(other.value) - at_x(value)) <
               (label_width(tick) + label_width(other)) / 2 + tick_gap;
      };
      if (std::any_of(asked.begin(), asked.end(), covered))
        continue;
      std::erase_if(x_ticks_, covered);
      asked.push_back(tick);
    }
    x_ticks_.insert(x_ticks_.end(), asked.begin(), asked.end());
    std::sort(x_ticks_.begin(), x_ticks_.end(),
              [this](const Tick& a, const Tick& b) { return at_x(a.value) < at_x(b.value); });
  }

  /// The corners of a triangle in the units of the axes: along, then up.
  [[nodiscard]] std::array<Spot, 3> corners(const SlopeTriangle& t) const {
    const double x0 = t.x0 / chart_.x.unit, x1 = t.x1 / chart_.x.unit, y0 = t.y0 / chart_.y.unit;
    return {{{x0, y0}, {x1, y0}, {x1, y0 * std::pow(x1 / x0, t.slope)}}};
  }

  [[nodiscard]] std::vector<double> values(Scale scale, bool vertical) const {
    std::vector<double> found;
    const auto take = [&](double value) {
      if (AxisRange::drawable(scale, value))
        found.push_back(value);
    };
    for (const DrawnSeries& series : drawn_)
      for (std::size_t k = 0; k < series.points.size(); ++k) {
        const double value = vertical ? series.points[k].y : series.points[k].x;
        take(value);
        if (vertical)
          for (const double end : {value - series.errors[k], value + series.errors[k]})
            take(end);
      }
    for (const SlopeTriangle& triangle : chart_.triangles)
      for (const Spot& corner : corners(triangle))
        take(vertical ? corner.y : corner.x);
    return found;
  }

  [[nodiscard]] double at_x(double x) const {
    const double share = x_.fraction(x);
    return left_ + chart_.width * (chart_.x.reversed ? 1 - share : share);
  }
  [[nodiscard]] double at_y(double y) const {
    const double share = y_.fraction(y);
    return top_ + chart_.height * (chart_.y.reversed ? share : 1 - share);
  }
  [[nodiscard]] Spot place(const Spot& p) const { return {at_x(p.x), at_y(p.y)}; }

  [[nodiscard]] std::string x_axis() const {
    std::string svg;
    double free_from = -1e9;
    const double foot = top_ + chart_.height;
    for (const Tick& tick : x_ticks_) {
      const double x = at_x(tick.value), half = label_width(tick) / 2;
      const bool labelled = tick.labelled() && x - half > free_from;
      svg += grid_line({x, top_}, {x, foot}, tick) + svg_line({x, foot}, {x, foot + (labelled ? 6 : 3)});
      if (!labelled)
        continue;
      free_from = x + half + tick_gap;
      svg +=
          svg_text("x-label", {{"x", svg_number(x)}, {"y", svg_number(foot + 22)}, {"text-anchor", "middle"}},
                   label_content(tick));
    }
    return svg + svg_text("x-title",
                          {{"x", svg_number(left_ + chart_.width / 2)},
                           {"y", svg_number(foot + 50)},
                           {"text-anchor", "middle"}},
                          svg_escaped(chart_.x.title));
  }

  [[nodiscard]] std::string y_axis() const {
    std::string svg;
    double free_below = 1e9;
    for (const Tick& tick : y_ticks_) {
      const double y = at_y(tick.value);
      const bool labelled = tick.labelled() && y < free_below;
      svg += grid_line({left_, y}, {left_ + chart_.width, y}, tick) +
             svg_line({left_ - (labelled ? 6 : 3), y}, {left_, y});
      if (!labelled)
        continue;
      free_below = y - font_size - 3;
      svg += svg_text("y-label",
                      {{"x", svg_number(left_ - 10)}, {"y", svg_number(y + 5)}, {"text-anchor", "end"}},
                      label_content(tick));
    }
    const std::string middle = svg_number(top_ + chart_.height / 2);
    return svg + svg_text("y-title",
                          {{"x", "20"},
                           {"y", middle},
                           {"text-anchor", "middle"},
                           {"transform", "rotate(-90 20 " + middle + ")"}},
                          svg_escaped(chart_.y.title));
  }

  [[nodiscard]] static std::string svg_line(const Spot& from, const Spot& to,
                                            const char* colour = "currentColor") {
    return svg_element("line", {{"x1", svg_number(from.x)},
                                {"y1", svg_number(from.y)},
                                {"x2", svg_number(to.x)},
                                {"y2", svg_number(to.y)},
                                {"stroke", colour}});
  }

  [[nodiscard]] static std::string grid_line(const Spot& from, const Spot& to, const Tick& tick) {
    return tick.labelled() ? svg_grid_line(from, to) : "";
  }

  /// Also has the meaning of the picture's coordinates for the page's script.
  [[nodiscard]] std::string frame() const {
    const auto range = [](const Axis& axis, const AxisRange& of) {
      const std::string low = short_text(of.low(), 12), high = short_text(of.high(), 12);
      return std::string(axis.scale == Scale::logarithmic ? "log " : "linear ") +
             (axis.reversed ? high + " " + low : low + " " + high);
    };
    return svg_element("rect", {{"class", "frame"},
                                {"x", svg_number(left_)},
                                {"y", svg_number(top_)},
                                {"width", svg_number(chart_.width)},
                                {"height", svg_number(chart_.height)},
                                {"fill", "none"},
                                {"stroke", "currentColor"},
                                {"data-x", range(chart_.x, x_)},
                                {"data-y", range(chart_.y, y_)}});
  }

  [[nodiscard]] std::string bar(const Spot& p, double error) const {
    const auto end = [this](double y, double edge) {
      return AxisRange::drawable(chart_.y.scale, y) ? at_y(y) : edge;
    };
    const double upper = top_, lower = top_ + chart_.height;
    return error_bar(at_x(p.x), end(p.y + error, chart_.y.reversed ? lower : upper),
                     end(p.y - error, chart_.y.reversed ? upper : lower));
  }

  [[nodiscard]] std::string curve(std::size_t index) const {
    const DrawnSeries& series = drawn_[index];
    const Mark mark = chart_.series[index].mark;
    const Look look(chart_.series[index], index);
    std::string path, dots, bars;
    for (std::size_t k = 0; k < series.points.size(); ++k) {
      const Spot p = place(series.points[k]);
      path += (series.joined[k] ? "L" : "M") + pair(p);
      dots += look.marker(p);
      if (series.errors[k] > 0)
        bars += bar(series.points[k], series.errors[k]);
    }
    if (mark == Mark::area)
      return svg_group(look.group(), path.empty() ? "" : surface(path + "Z"));
    std::string svg;
    if (mark != Mark::marker && !path.empty()) {
      SvgAttributes attributes = look.stroke();
      attributes.emplace_back("d", path);
      svg += svg_element("path", attributes);
    }
    svg += svg_group({{"fill", "none"}, {"stroke", "currentColor"}}, bars);
    if (mark != Mark::line)
      svg += svg_group(look.filling(), dots);
    return svg_group(look.group(), svg);
  }

  /// Places of the texts beside the triangles, each a line away from those that it would lie upon.
  [[nodiscard]] std::vector<Spot> triangle_texts() const {
    constexpr double line = font_size + 2;
    std::vector<Spot> out;
    std::vector<std::size_t> order;
    for (const SlopeTriangle& triangle : chart_.triangles) {
      const std::array<Spot, 3> c = corners(triangle);
      const Spot corner = place(c[1]), end = place(c[2]);
      order.push_back(out.size());
      out.push_back({corner.x + 6, (corner.y + end.y) / 2 + 5});
    }
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return out[a].y < out[b].y; });
    for (std::size_t k = 1; k < order.size(); ++k) {
      const Spot& above = out[order[k - 1]];
      Spot& below = out[order[k]];
      if (std::abs(above.x - below.x) < 1 && below.y - above.y < line) {
        const double apart = (line - (below.y - above.y)) / 2;
        out[order[k - 1]].y -= apart;
        below.y += apart;
      }
    }
    return out;
  }

  /// The text of a triangle, in the colour of its line.
  [[nodiscard]] static std::string slope_label(const SlopeTriangle& triangle, const Spot& at) {
    SvgAttributes place{{"x", svg_number(at.x)}, {"y", svg_number(at.y)}};
    if (!triangle.colour)
      return svg_text("slope", place, svg_escaped(triangle.text));
    place.emplace_back("fill", "currentColor");
    const SvgAttributes colour = svg_colour(*triangle.colour);
    place.emplace_back("color", colour.back().second);
    return svg_text("slope " + colour.front().second, place, svg_escaped(triangle.text));
  }

  [[nodiscard]] std::string triangles() const {
    std::string svg;
    const std::vector<Spot> texts = triangle_texts();
    for (std::size_t k = 0; k < texts.size(); ++k) {
      const SlopeTriangle& triangle = chart_.triangles[k];
      const std::array<Spot, 3> c = corners(triangle);
      SvgAttributes look{{"fill", "none"}, {"stroke", "currentColor"}, {"stroke-width", "1.3"}};
      if (triangle.colour)
        for (auto& attribute : svg_colour(*triangle.colour))
          look.push_back(std::move(attribute));
      look.emplace_back("d", "M" + pair(place(c[0])) + "L" + pair(place(c[1])) + "L" + pair(place(c[2])));
      // On paper of its own, so that the frame does not strike it through.
      constexpr double rise = 12, paper_height = 16;
      svg += svg_element("path", look) +
             svg_element("rect", {{"class", "paper"},
                                  {"x", svg_number(texts[k].x - 1)},
                                  {"y", svg_number(texts[k].y - rise)},
                                  {"width", svg_number(text_width(triangle.text) + 2)},
                                  {"height", svg_number(paper_height)},
                                  {"fill", "white"}}) +
             slope_label(triangle, texts[k]);
    }
    return svg;
  }

  const Chart& chart_;
  Legend legend_;
  std::vector<DrawnSeries> drawn_;
  AxisRange x_;
  AxisRange y_;
  std::vector<Tick> x_ticks_;
  std::vector<Tick> y_ticks_;
  double left_ = 64;
  double right_ = least_right;
  std::vector<std::string> title_;
  double top_ = 14;
};

/// Where each series goes, in numbers.
std::string described(const Chart& chart) {
  std::string text = chart.title.empty() ? chart.y.title + " over " + chart.x.title : chart.title;
  for (const Series& series : chart.series) {
    const DrawnSeries drawn(chart, series);
    if (series.name.empty() || drawn.points.empty())
      continue;
    const Spot first = drawn.points.front(), last = drawn.points.back();
    text += "; " + series.name + ": " + short_text(first.y, 3) + " at " + short_text(first.x, 3) + ", " +
            short_text(last.y, 3) + " at " + short_text(last.x, 3);
  }
  return text;
}

Canvas canvas_of(const Chart& chart) {
  require_valid(chart);
  const Chart drawn = chart.rose ? chart : with_coinciding_once(chart);
  Canvas out = chart.rose ? rose_canvas(chart) : Picture(drawn).canvas();
  out.finding = chart.finding.empty() ? described(chart) : chart.finding;
  return out;
}

} // namespace

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

std::string svg(const Chart& chart) { return canvas_of(chart).text(true); }
std::string svg_in_page(const Chart& chart) { return canvas_of(chart).text(false); }

std::string svg(std::span<const Chart> charts, std::size_t in_a_row) {
  if (charts.empty() || in_a_row == 0)
    throw InvalidArgument("a picture needs a chart");
  if (charts.size() == 1)
    return svg(charts.front());
  Canvas all;
  double left = 0, top = 0;
  for (std::size_t k = 0; k < charts.size(); ++k) {
    if (k > 0 && k % in_a_row == 0) {
      left = 0;
      top = all.height;
    }
    const Canvas one = canvas_of(charts[k]);
    const std::string shift = "translate(" + svg_number(left) + " " + svg_number(top) + ")";
    all.content += svg_group({{"transform", shift}}, one.drawn());
    all.finding += (k == 0 ? "" : " ") + one.finding;
    left += one.width;
    all.width = std::max(all.width, left);
    all.height = std::max(all.height, top + one.height);
  }
  return all.text(true);
}

} // namespace granum::plot
