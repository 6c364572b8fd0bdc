// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace granum::hardin {

/// y = c_0 + c_1 x + c_2 x^2 + ... by least squares.
struct Polynomial {
  std::vector<double> coefficients; ///< c_0, c_1, ... in units of y over powers of x
  double rms = 0;                   ///< distance of the points from the curve, in units of y
};

/// Assumes   x of order 1, shifted near its middle: powers of large numbers lose digits.
/// \param    x, y    as many of each, at least degree + 1 points
/// \param    degree  in [0, 8]
/// \throws   InvalidArgument outside these ranges, for an x or y that is not finite, and where x to the
///           degree or y is beyond 1e150; NotConverged if the least squares fail
/// GSL reports its errors to this function alone: a handler of the program is neither called nor replaced.
/// Accuracy  points on a polynomial give its coefficients to 1e-12 where abs(x) <= 2.
/// Checked by tests/hardin/test_polynomial.cpp
[[nodiscard]] Polynomial fit_polynomial(std::span<const double> x, std::span<const double> y,
                                        std::size_t degree);

} // namespace granum::hardin
