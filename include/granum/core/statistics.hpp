// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

/// A number with its standard error, means, and the line of least squares.
namespace granum {

/// 2 a b/(a + b) of two positive numbers, not checked; exactly a where b is a, and without overflow.
/// Accuracy  2 ulp.  Checked by tests/contact/test_pair.cpp
[[nodiscard]] constexpr double harmonic_mean(double a, double b) noexcept { return 2 * a * (b / (a + b)); }

/// A measured, fitted or estimated number and its standard error, in the unit of the number.
struct Measured {
  double value = 0;
  double standard_error = 0; ///< >= 0; 0 for an exact number
};

/// A point (x, y).
struct Point {
  double x = 0;
  double y = 0;
};

/// A straight line through points, each with the same unknown error in y.
struct StraightLine {
  double mean_x = 0; ///< the line goes through (mean_x, mean_y)
  double mean_y = 0;
  Measured slope; ///< its error by the scatter about the line; 0 through two points

  [[nodiscard]] double operator()(double x) const { return mean_y + slope.value * (x - mean_x); }
};

/// The line of least squares in y. Of ln G against ln p its slope is the exponent s of G ~ p^s.
/// \throws   InvalidArgument for fewer than two points, for coordinates that are not finite, or if all x are
///           the same
/// Accuracy  1e-13 of the slope where the x spread over more than a hundredth of their size.
///           Checked by tests/core/test_straight_line.cpp
[[nodiscard]] StraightLine straight_line(std::span<const Point> points);

} // namespace granum
