// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardin/nonlinear_fit.hpp"

#include <stdexcept>

#include "unit.hpp"

namespace {

/// Rosenbrock's valley: least at (1, 1).
Eigen::VectorXd valley(const Eigen::VectorXd& x) {
  return Eigen::Vector2d(10 * (x[1] - x[0] * x[0]), 1 - x[0]);
}
Eigen::MatrixXd valley_slopes(const Eigen::VectorXd& x) {
  Eigen::Matrix2d slopes;
  slopes << -20 * x[0], 10, -1, 0;
  return slopes;
}

} // namespace

TEST_CASE("nonlinear fit: the bottom of a bent valley, and too few steps to it") {
  const Eigen::Vector2d start(-1.2, 1);
  const auto found = hardin::solve({valley, valley_slopes}, start, 100, "a valley");
  CHECK(found.status == hardin::FitStatus::converged);
  CHECK(found.theta.isApprox(Eigen::Vector2d(1, 1), 1e-12));
  const auto stopped = hardin::solve({valley, valley_slopes}, start, 2, "a valley");
  CHECK(stopped.status == hardin::FitStatus::iteration_limit);
  CHECK(stopped.iterations == 2);
}

TEST_CASE("nonlinear fit: exceptions pass by GSL") {
  const Eigen::Vector2d start(-1.2, 1);
  int calls = 0;
  const auto residuals = [&](const Eigen::VectorXd& x) {
    if (++calls > 3)
      throw InvalidArgument("beyond the range");
    return valley(x);
  };
  CHECK_THROWS_WITH_AS((void)hardin::solve({residuals, valley_slopes}, start, 100, "a valley"),
                       "beyond the range", InvalidArgument);
  const auto no_slopes = [](const Eigen::VectorXd&) -> Eigen::MatrixXd { throw std::runtime_error("none"); };
  CHECK_THROWS_WITH_AS((void)hardin::solve({valley, no_slopes}, start, 100, "a valley"), "none",
                       std::runtime_error);
}
