// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

/// A number with its standard error, means, the line of least squares, and quadrature.
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
///           Checked by tests/core/test_numerics.cpp
[[nodiscard]] StraightLine straight_line(std::span<const Point> points);

/// One point of a quadrature rule.
struct QuadratureNode {
  double abscissa = 0;
  double weight = 0;
};

/// Gauss-Legendre rule on [-1, 1], abscissas ascending and symmetric; exact for polynomials up to degree
/// 2 order - 1. Computed anew at each call: keep the result.
/// \param    order   number of points, in [1, 1024]
/// \throws   InvalidArgument for another order
/// Accuracy  abscissas and weights 2 ulp.  Checked by tests/core/test_numerics.cpp
[[nodiscard]] std::vector<QuadratureNode> gauss_legendre(int order);

} // namespace granum
