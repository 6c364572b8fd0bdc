// SPDX-License-Identifier: GPL-3.0-or-later
// Replacement of GSL, which the page does not have: the single function used by granum::inverse, implemented
// with Eigen's port of MINPACK. The contact model then takes a further step to the minimum, so that its
// numbers agree with those of the native program (web/tests/numbers.test.mjs).
#include <unsupported/Eigen/NonLinearOptimization>

#include "hardin/nonlinear_fit.hpp"

namespace granum::hardin {

namespace {

/// The problem in the form required by Eigen; 0 means that a call succeeded.
struct Residuals {
  const NonlinearProblem& problem;
  Eigen::Index count;

  [[nodiscard]] int values() const { return static_cast<int>(count); }
  int operator()(const Eigen::VectorXd& theta, Eigen::VectorXd& misfit) const {
    misfit = problem.residuals(theta);
    return 0;
  }
  int df(const Eigen::VectorXd& theta, Eigen::MatrixXd& jacobian) const {
    jacobian = problem.jacobian(theta);
    return 0;
  }
};

} // namespace

NonlinearSolution solve(const NonlinearProblem& problem, const Eigen::VectorXd& start,
                        std::size_t iteration_limit, const char* /*what*/) {
  namespace status = Eigen::LevenbergMarquardtSpace;
  Residuals residuals{problem, problem.residuals(start).size()};
  Eigen::LevenbergMarquardt<Residuals> search(residuals);
  search.parameters.ftol = search.parameters.xtol = 1e-13;
  NonlinearSolution found{FitStatus::iteration_limit, 0, start};
  if (search.minimizeInit(found.theta) == status::ImproperInputParameters)
    return found;
  auto outcome = status::Running;
  for (; outcome == status::Running && found.iterations < iteration_limit; ++found.iterations)
    outcome = search.minimizeOneStep(found.theta);
  if (outcome != status::Running && outcome != status::TooManyFunctionEvaluation)
    found.status = FitStatus::converged;
  return found;
}

} // namespace granum::hardin
