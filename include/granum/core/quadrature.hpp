// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace granum {

/// One point of a quadrature rule.
struct QuadratureNode {
  double abscissa = 0;
  double weight = 0;
};

/// Gauss-Legendre rule on [-1, 1], abscissas ascending and symmetric; exact for polynomials up to degree
/// 2 order - 1. Computed anew at each call: keep the result.
/// \param    order   number of points, in [1, 1024]
/// \throws   InvalidArgument for another order
/// Accuracy  abscissas and weights 2 ulp.  Checked by tests/core/test_quadrature.cpp
[[nodiscard]] std::vector<QuadratureNode> gauss_legendre(int order);

} // namespace granum
