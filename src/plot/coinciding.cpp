// SPDX-License-Identifier: GPL-3.0-or-later
#include "coinciding.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ticks.hpp"

namespace granum::plot {

namespace {

/// Where numbers stand on an axis, up to a shift [pixels].
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

} // namespace granum::plot
