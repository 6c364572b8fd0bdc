// SPDX-License-Identifier: GPL-3.0-or-later
// The means are integrals over x = n3 from 0 to 1 of functions of f/f_ref, f = A (1 - x^2) + B x^2, whose
// branch points approach the interval as A/B leaves 1. The substitution tan(gamma) -> c tan(gamma),
// c^2 = sqrt(A/B), halves that ratio on a logarithmic scale and makes both sides of 1 alike:
//   x^2 = c^2 y^2/g,  1 - x^2 = (1 - y^2)/g,  dx = c g^(-3/2) dy,  g = 1 + (c^2-1) y^2,
//   f = sqrt(A B) h/g,  h = c^2 + (1-c^2) y^2.
// A Gauss-Legendre rule of n points in y then errs by about exp(-2 n/(A/B)^(1/4)) for large A/B.
#include "kernels.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <granum/core/quadrature.hpp>

namespace granum::effective::kernel {

namespace {

/// The integrand is even: half of the symmetric rule will do.
std::vector<QuadratureNode> positive_half(int order) {
  const std::vector<QuadratureNode> rule = gauss_legendre(order);
  return {rule.begin() + order / 2, rule.end()};
}

/// Orders whose error exp(-2 n artanh((A/B)^(-1/4))) stays below 1e-16 up to force ratios of 4, 40 and 1e4.
const std::vector<QuadratureNode>& rule_for(double force_ratio) {
  static const std::vector<QuadratureNode> mild = positive_half(24);
  static const std::vector<QuadratureNode> usual = positive_half(48);
  static const std::vector<QuadratureNode> extreme = positive_half(256);
  const double ratio = std::max(force_ratio, 1 / force_ratio);
  return ratio <= 4 ? mild : ratio <= 40 ? usual : extreme;
}

/// A weight ~ f^exponent as a number of type T; share_v is the part of f that stress_v carries.
template <class T>
T weighted(double weight, double exponent, double share_v);
template <>
double weighted<double>(double weight, double, double) {
  return weight;
}
template <>
LogDual weighted<LogDual>(double weight, double exponent, double share_v) {
  return {weight, weight * exponent * share_v, weight * exponent * (1 - share_v)};
}

template <class T>
AxialMoments<T> moments(double a, const StaticForceField& field, double exponent) {
  const double force_ratio = field.horizontal / field.vertical;
  const double c2 = std::sqrt(force_ratio);
  const double scale = 3 * std::sqrt(c2) / (3 - a);
  AxialMoments<T> sum;
  for (const auto& [y, weight] : rule_for(force_ratio)) {
    const double y2 = y * y;
    const double g = 1 + (c2 - 1) * y2;
    const double h = c2 + (1 - c2) * y2;
    const double x2 = c2 * y2 / g;
    const double density = 1 - a + 2 * a * x2;
    const double value = weight * scale * density / (g * std::sqrt(g)) * std::pow(h / g, exponent);
    const T term = weighted<T>(value, exponent, y2 / h);
    sum.m0 = sum.m0 + term;
    sum.m2 = sum.m2 + x2 * term;
    sum.m4 = sum.m4 + x2 * x2 * term;
  }
  return sum;
}

} // namespace

AxialMoments<double> stiffness_moments(double anisotropy, const StaticForceField& field, double b,
                                       double sign) {
  return moments<double>(anisotropy, field, sign * b);
}

AxialMoments<LogDual> stiffness_moment_slopes(double anisotropy, const StaticForceField& field, double b,
                                              double sign) {
  return moments<LogDual>(anisotropy, field, sign * b);
}

} // namespace granum::effective::kernel
