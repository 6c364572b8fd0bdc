// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/core/quadrature.hpp>

#include <boost/math/special_functions/legendre.hpp>

#include <granum/core/error.hpp>

namespace granum {

std::vector<QuadratureNode> gauss_legendre(int order) {
  require_closed("order", order, 1, 1024);
  const auto n = static_cast<std::size_t>(order);
  const std::vector<long double> zeros =
      boost::math::legendre_p_zeros<long double>(order); // those >= 0, ascending
  std::vector<QuadratureNode> rule(n);
  for (std::size_t i = 0; i < zeros.size(); ++i) {
    const long double x = zeros[i];
    const long double slope = boost::math::legendre_p_prime(order, x);
    const auto weight = static_cast<double>(2 / ((1 - x * x) * slope * slope));
    const std::size_t right = n / 2 + i;
    rule[right] = {static_cast<double>(x), weight};
    rule[n - 1 - right] = {-static_cast<double>(x), weight};
  }
  return rule;
}

} // namespace granum
