// SPDX-License-Identifier: GPL-3.0-or-later
// Range, ticks and labels of one axis of a chart.
#pragma once

#include <string>
#include <vector>

#include <granum/plot/chart.hpp>

namespace granum::plot {

struct Tick {
  double value = 0;
  std::string mantissa; ///< "20", or what stands before the power; both empty: a small tick without label
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

} // namespace granum::plot
