// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/core/numerics.hpp>

#include "unit.hpp"

TEST_CASE("points on a line give the line without error, others one with the error of the text books") {
  std::vector<Point> exact;
  for (double x : {-3.0, 0.5, 2.0, 11.0})
    exact.push_back({x, 7 - 0.25 * x});
  CHECK(straight_line(exact).slope.value == doctest::Approx(-0.25).epsilon(1e-14));
  CHECK(straight_line(exact).slope.standard_error < 1e-15);
  CHECK(straight_line(exact)(100) == doctest::Approx(-18).epsilon(1e-14));
  exact.resize(2); // no more points than numbers to find
  CHECK(straight_line(exact).slope.standard_error == 0);
  // By hand: mean (3, 5.96), sum of squares of x 10, of products 19.5.
  const std::vector<Point> points{{1, 2.1}, {2, 3.9}, {3, 6.2}, {4, 7.6}, {5, 10.0}};
  const StraightLine line = straight_line(points);
  CHECK(line.slope.value == doctest::Approx(1.95).epsilon(1e-14));
  double rest = 0;
  for (const Point& point : points)
    rest += std::pow(point.y - (5.96 + 1.95 * (point.x - 3)), 2);
  CHECK(line.slope.standard_error == doctest::Approx(std::sqrt(rest / 3 / 10)).epsilon(1e-12));
}

TEST_CASE("points that have no line are refused") {
  const double infinite = std::numeric_limits<double>::infinity();
  for (const std::vector<Point>& points :
       {std::vector<Point>{}, std::vector<Point>{{1, 1}}, std::vector<Point>{{1, 1}, {1, 2}, {1, 3}},
        std::vector<Point>{{1, 1}, {infinite, 2}}})
    CHECK_THROWS_AS((void)straight_line(points), InvalidArgument);
}
