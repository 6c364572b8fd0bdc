// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/core/numerics.hpp>

#include "core/compiled_once.hpp"
#include "unit.hpp"

TEST_CASE("Gauss-Legendre rules integrate polynomials up to degree 2 n - 1 exactly and no further") {
  for (const int order : {1, 2, 3, 7, 16, 48, 101}) {
    CAPTURE(order);
    const auto rule = gauss_legendre(order);
    REQUIRE(rule.size() == static_cast<std::size_t>(order));
    const auto integral = [&](int degree) {
      double sum = 0;
      for (const auto& [x, w] : rule)
        sum += w * std::pow(x, degree);
      return sum;
    };
    for (int degree = 0; degree < 2 * order; ++degree) // rounding of n terms of sum 2
      CHECK(std::abs(integral(degree) - (degree % 2 == 0 ? 2.0 / (degree + 1) : 0.0)) < 2e-15);
    if (order <= 7)
      CHECK(std::abs(integral(2 * order) - 2.0 / (2 * order + 1)) > 1e-5);
  }
}

TEST_CASE("Gauss-Legendre rules are ascending, symmetric and positive") {
  for (const int order : {2, 15, 256}) {
    const auto rule = gauss_legendre(order);
    for (std::size_t i = 0; i < rule.size(); ++i) {
      const auto& mirror = rule[rule.size() - 1 - i];
      CHECK(rule[i].weight > 0);
      CHECK(rule[i].abscissa == -mirror.abscissa);
      CHECK(rule[i].weight == mirror.weight);
      if (i > 0)
        CHECK(rule[i].abscissa > rule[i - 1].abscissa);
    }
  }
  CHECK(gauss_legendre(3)[2].abscissa == doctest::Approx(std::sqrt(0.6)).epsilon(2e-16));
  CHECK(gauss_legendre(3)[1].abscissa == 0);
  for (const int bad : {0, -3, 1025})
    CHECK_THROWS_AS((void)gauss_legendre(bad), InvalidArgument);
}

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
  std::vector<Point> small = points; // near each other, however near
  for (Point& point : small)
    point.x *= 1e-9;
  CHECK(straight_line(small).slope.value == doctest::Approx(1.95e9).epsilon(1e-14));
}

TEST_CASE("the probability of a larger chi square has its closed forms") {
  for (const double chi_square : {0.0, 0.3, 2.0, 11.0}) {
    CHECK(p_value(chi_square, 0) == 1);
    CHECK(p_value(chi_square, 1) == doctest::Approx(std::erfc(std::sqrt(chi_square / 2))).epsilon(1e-13));
    CHECK(p_value(chi_square, 2) == doctest::Approx(std::exp(-chi_square / 2)).epsilon(1e-13));
  }
}

TEST_CASE("points that have no line are refused") {
  const double infinite = std::numeric_limits<double>::infinity();
  for (const std::vector<Point>& points :
       {std::vector<Point>{}, std::vector<Point>{{1, 1}}, std::vector<Point>{{1, 1}, {1, 2}, {1, 3}},
        std::vector<Point>{{1, 1}, {infinite, 2}}})
    CHECK_THROWS_AS((void)straight_line(points), InvalidArgument);
}
