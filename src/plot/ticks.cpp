// SPDX-License-Identifier: GPL-3.0-or-later
#include "ticks.hpp"

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

} // namespace granum::plot
