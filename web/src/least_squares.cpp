// SPDX-License-Identifier: GPL-3.0-or-later
// What takes the place of GSL, which the page does not have: the one function that granum::inverse asks it
// for. The contact model goes on from here to the minimum by a step of its own, so that its numbers are those
// of the native program (web/tests/numbers.test.mjs).
#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "hardin/nonlinear_fit.hpp"

namespace granum::hardin {

/// Levenberg-Marquardt, damped by the diagonal of the normal equations.
NonlinearSolution solve(const NonlinearProblem& problem, const Eigen::VectorXd& start,
                        std::size_t iteration_limit, const char* /*what*/) {
  constexpr double no_step = 1e-13, most_damping = 1e15;
  NonlinearSolution found{FitStatus::iteration_limit, 0, start};
  Eigen::VectorXd misfit = problem.residuals(found.theta);
  double damping = 1e-3;
  for (; found.iterations < iteration_limit; ++found.iterations) {
    const Eigen::MatrixXd jacobian = problem.jacobian(found.theta);
    const Eigen::MatrixXd normal = jacobian.transpose() * jacobian;
    for (bool better = false; !better; damping *= better ? 0.1 : 10) {
      Eigen::MatrixXd damped = normal;
      damped.diagonal() *= 1 + damping;
      const Eigen::VectorXd step = damped.ldlt().solve(-jacobian.transpose() * misfit);
      const Eigen::VectorXd theta = found.theta + step, there = problem.residuals(theta);
      better = there.squaredNorm() < misfit.squaredNorm();
      if (better) {
        found.theta = theta;
        misfit = there;
      }
      // Where no step helps this is the minimum, to rounding.
      if (step.norm() <= no_step * (1 + found.theta.norm()) || damping > most_damping) {
        found.status = FitStatus::converged;
        return found;
      }
    }
  }
  return found;
}

} // namespace granum::hardin
