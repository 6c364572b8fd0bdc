// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/core/numerics.hpp>

#include <cmath>

#include <boost/math/special_functions/legendre.hpp>

#include <granum/core/error.hpp>

namespace granum {

StraightLine straight_line(std::span<const Point> points) {
  if (points.size() < 2)
    throw InvalidArgument("points of a straight line", static_cast<double>(points.size()), "", "at least 2");
  const double count = static_cast<double>(points.size());
  StraightLine line;
  for (const Point& point : points) {
    line.mean_x += require_finite("x of a point", point.x, "") / count;
    line.mean_y += require_finite("y of a point", point.y, "") / count;
  }
  double xx = 0, xy = 0;
  for (const Point& point : points) {
    xx += (point.x - line.mean_x) * (point.x - line.mean_x);
    xy += (point.x - line.mean_x) * (point.y - line.mean_y);
  }
  if (!(xx > 0))
    throw InvalidArgument("spread of x of the points", xx, "", "more than 0");
  line.slope.value = xy / xx;
  if (points.size() == 2)
    return line;
  double rest = 0;
  for (const Point& point : points)
    rest += std::pow(point.y - line(point.x), 2);
  line.slope.standard_error = std::sqrt(rest / (count - 2) / xx);
  return line;
}

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
