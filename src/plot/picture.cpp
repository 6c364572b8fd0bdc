// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <granum/core/text.hpp>

namespace granum::plot {

namespace {

constexpr double largest = std::numeric_limits<double>::max();
constexpr double margin = 0.04;      // of the range, at either end
constexpr int most_labels = 7;       // on an axis, about
constexpr double resolution = 1e-12; // of a value: what lies closer together counts as one value
constexpr double smallest = 1e-290;  // magnitudes below count as 0

/// 1, 2 or 5 times a power of ten, not below `least` > 0.
double nice_step(double least) {
  const double power = std::pow(10, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= least * (1 - 1e-9))
      return factor * power;
  return 10 * power;
}

int decade_of(double value) { return static_cast<int>(std::floor(std::log10(value) + 1e-9)); }

/// Labels of the multiples of a step, all in one style: plain, or with one power of ten.
class LinearLabels {
 public:
  LinearLabels(double step, double magnitude) {
    const int largest_decade = decade_of(std::max(step, magnitude));
    digits_ = std::clamp(largest_decade - decade_of(step) + 1, 6, 17);
    if (largest_decade > 5 || decade_of(step) < -4)
      power_ = largest_decade;
  }

  [[nodiscard]] Tick tick(double value) const {
    if (power_ == 0 || value == 0)
      return {value, short_text(value, digits_), ""};
    return {value, short_text(value / std::pow(10, power_), digits_) + "\u00b7", std::to_string(power_)};
  }

 private:
  int digits_ = 6;
  int power_ = 0;
};

Tick logarithmic_tick(double factor, int decade, bool labelled, bool plain) {
  // through text, so that 1e-3 and 5e22 are the nearest doubles
  const double value =
      parse_number(short_text(factor) + "e" + std::to_string(decade)).value_or(std::pow(10, decade) * factor);
  if (!labelled)
    return {value, "", ""};
  if (plain)
    return {value, short_text(value), ""};
  return {value, factor == 1 ? "" : short_text(factor) + "\u00b7", std::to_string(decade)};
}

} // namespace

bool AxisRange::drawable(Scale scale, double value) {
  return std::isfinite(value) && (scale == Scale::linear || value >= smallest);
}

AxisRange::AxisRange(Scale scale, const std::vector<double>& values) : scale_(scale) {
  if (values.empty())
    return;
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const bool logarithmic = scale == Scale::logarithmic;
  low_ = logarithmic ? std::log10(*least) : *least;
  high_ = logarithmic ? std::log10(*most) : *most;
  const double magnitude = std::max(std::abs(low_), std::abs(high_));
  const bool one_value =
      high_ / 2 - low_ / 2 <= (logarithmic ? resolution : std::max(resolution * magnitude, smallest));
  double extra = margin * 2 * (high_ / 2 - low_ / 2);
  if (one_value)
    extra = logarithmic ? 0.5 : magnitude > smallest ? magnitude / 10 : 1;
  extra = std::min(extra, largest / 100);
  low_ = std::max(low_ - extra, logarithmic ? -300.0 : -largest);
  high_ = std::min(high_ + extra, logarithmic ? 308.25 : largest);
}

double AxisRange::fraction(double value) const {
  const double place = scale_ == Scale::logarithmic ? std::log10(value) : value;
  return (place / 2 - low_ / 2) /
         (high_ / 2 - low_ / 2); // halves, so that the widest range does not overflow
}

std::vector<Tick> AxisRange::ticks() const {
  return scale_ == Scale::logarithmic ? logarithmic_ticks() : linear_ticks();
}

std::vector<Tick> AxisRange::linear_ticks() const {
  const bool logarithmic = scale_ == Scale::logarithmic;
  const double low = logarithmic ? std::pow(10, low_) : low_;
  const double high = logarithmic ? std::pow(10, high_) : high_;
  const double step = nice_step((high / 2 - low / 2) / (0.5 * most_labels));
  const LinearLabels labels(step, std::max(std::abs(low), std::abs(high)));
  std::vector<Tick> ticks;
  for (double k = std::ceil(low / step); k * step <= high && ticks.size() < 2 * most_labels; ++k)
    ticks.push_back(labels.tick(k * step + 0.0)); // + 0.0: no negative zero
  return ticks;
}

std::vector<Tick> AxisRange::logarithmic_ticks() const {
  const int first = static_cast<int>(std::floor(low_));
  const int last = static_cast<int>(std::floor(high_));
  const double decades = high_ - low_;
  if (decades < 0.8)
    return linear_ticks();
  const int stride = static_cast<int>(std::ceil(decades / most_labels));
  const bool plain = first >= -4 && last <= 4;
  std::vector<Tick> ticks;
  for (int decade = first; decade <= last; ++decade)
    for (int factor = 1; factor <= (stride == 1 ? 9 : 1); ++factor) {
      const double place = decade + std::log10(factor);
      const bool between = factor == 2 || factor == 5;
      const bool labelled = factor == 1 ? decade % stride == 0 : between && decades <= 2.2;
      if (place >= low_ && place <= high_ && (labelled || stride == 1))
        ticks.push_back(logarithmic_tick(factor, decade, labelled, plain));
    }
  return ticks;
}

namespace {

/// Positions of the numbers on an axis, up to a shift [pixels].
class Places {
 public:
  /// Between the smallest and the largest number that can be drawn; an axis is that long or longer.
  Places(Scale scale, double length, const std::vector<Series>& all, const std::vector<double> Series::*of)
      : scale_(scale) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Series& series : all)
      for (const double value : series.*of)
        if (AxisRange::drawable(scale, value)) {
          low = std::min(low, measure(value));
          high = std::max(high, measure(value));
        }
    pixels_ = high > low ? 0.5 * length / (0.5 * high - 0.5 * low) : 0;
  }

  /// Two numbers that cannot be drawn are the same gap.
  [[nodiscard]] bool one(double a, double b) const {
    const bool drawn = AxisRange::drawable(scale_, a);
    if (drawn != AxisRange::drawable(scale_, b))
      return false;
    return !drawn || std::abs(measure(a) - measure(b)) * pixels_ <= one_point;
  }
  [[nodiscard]] bool one(const std::vector<double>& a, const std::vector<double>& b) const {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [this](double x, double y) { return one(x, y); });
  }
  [[nodiscard]] bool draws(const std::vector<double>& values) const {
    return std::any_of(values.begin(), values.end(),
                       [this](double v) { return AxisRange::drawable(scale_, v); });
  }

 private:
  [[nodiscard]] double measure(double value) const {
    return scale_ == Scale::logarithmic ? std::log(value) : value;
  }

  Scale scale_;
  double pixels_ = 0; ///< for each unit of the measure
};

bool is_curve(const Series& series) {
  return (series.mark == Mark::line || series.mark == Mark::both) && series.x.size() > 1 &&
         !series.name.empty() && series.y_error.empty() && series.kind.empty();
}

} // namespace

Chart with_coinciding_once(Chart chart) {
  const Places across(chart.x.scale, chart.width, chart.series, &Series::x);
  const Places up(chart.y.scale, chart.height, chart.series, &Series::y);
  const auto coincide = [&](const Series& a, const Series& b) {
    return is_curve(b) && a.mark == b.mark && a.tone == b.tone && up.draws(b.y) && across.one(a.x, b.x) &&
           up.one(a.y, b.y);
  };
  for (std::size_t first = 0; first < chart.series.size(); ++first) {
    Series& kept = chart.series[first];
    bool alone = true;
    for (std::size_t k = first + 1; is_curve(kept) && k < chart.series.size(); ++k)
      if (Series& other = chart.series[k]; coincide(kept, other)) {
        kept.name += ", " + other.name;
        other.name.clear();
        other.x.clear();
        other.y.clear();
        alone = false;
      }
    if (!alone)
      kept.name += ": one curve";
  }
  return chart;
}

DrawnSeries::DrawnSeries(const Chart& chart, const Series& series) {
  bool gap = false;
  for (std::size_t k = 0; k < series.x.size(); ++k) {
    const Spot p{series.x[k] / chart.x.unit, series.y[k] / chart.y.unit};
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

std::string svg_grid_line(const Spot& from, const Spot& to) {
  return svg_element("line", {{"class", "grid"},
                              {"x1", svg_number(from.x)},
                              {"y1", svg_number(from.y)},
                              {"x2", svg_number(to.x)},
                              {"y2", svg_number(to.y)},
                              {"stroke", "#dfe3e8"}});
}

std::string Canvas::drawn() const {
  std::string out;
  double y = 30;
  for (const std::string& line : title) {
    out += svg_text("title",
                    {{"x", svg_number(width / 2)},
                     {"y", svg_number(y)},
                     {"text-anchor", "middle"},
                     {"font-size", svg_number(title_size)}},
                    svg_escaped(line));
    y += title_line;
  }
  return out + content;
}

std::string Canvas::text(bool of_its_own) const {
  const std::string w = svg_number(width), h = svg_number(height);
  SvgAttributes root;
  if (of_its_own)
    root = {{"xmlns", "http://www.w3.org/2000/svg"}};
  root.insert(root.end(), {{"class", "chart"},
                           {"role", "img"},
                           {"aria-label", finding},
                           {"width", w},
                           {"height", h},
                           {"viewBox", "0 0 " + w + " " + h},
                           {"font-family", "Helvetica, Arial, sans-serif"},
                           {"font-size", svg_number(font_size)},
                           {"color", "#1c1f23"},
                           {"fill", "currentColor"}});
  std::string tag = svg_element("svg", root);
  tag.replace(tag.rfind("/>"), 2, ">");
  return (of_its_own ? "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" : "") + tag +
         (of_its_own ? "<style>" + dark_rules() + "</style>\n" : "") +
         svg_element("rect", {{"class", "paper"}, {"width", "100%"}, {"height", "100%"}, {"fill", "white"}}) +
         drawn() + "</svg>\n";
}

std::string svg(const SvgPicture& picture) {
  return Canvas{.width = picture.width,
                .height = picture.height,
                .content = picture.content,
                .finding = picture.finding}
      .text(true);
}

std::string svg_in_page(const SvgPicture& picture) {
  return Canvas{.width = picture.width,
                .height = picture.height,
                .content = picture.content,
                .finding = picture.finding}
      .text(false);
}

} // namespace granum::plot
