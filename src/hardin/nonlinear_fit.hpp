// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

#include <Eigen/Core>
#include <granum/hardin/fit.hpp>

/// Non-linear least squares by GSL, whose C interface ends here.
namespace granum::hardin {

/// Residuals of the parameters, at least as many as there are parameters, and their derivatives, a column for
/// each parameter.
struct NonlinearProblem {
  std::function<Eigen::VectorXd(const Eigen::VectorXd& theta)> residuals;
  std::function<Eigen::MatrixXd(const Eigen::VectorXd& theta)> jacobian;
};

struct NonlinearSolution {
  FitStatus status = FitStatus::converged;
  std::size_t iterations = 0;
  Eigen::VectorXd theta;
};

/// The parameters at which the sum of squared residuals is least, by Levenberg-Marquardt with a trust region,
/// to rounding. [More1978]
/// \param    what   name of the model, for errors: "Eq. (1)"
/// \throws   exceptions of the functions of the problem; NotConverged if GSL cannot begin
/// Checked by tests/hardin/test_nonlinear_fit.cpp
NonlinearSolution solve(const NonlinearProblem& problem, const Eigen::VectorXd& start,
                        std::size_t iteration_limit, const char* what);

} // namespace granum::hardin
