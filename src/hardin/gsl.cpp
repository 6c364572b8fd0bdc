// SPDX-License-Identifier: GPL-3.0-or-later
#include "gsl.hpp"

#include <cmath>
#include <exception>
#include <memory>
#include <mutex>
#include <string>

#include <gsl/gsl_multifit_nlinear.h>

#include "nonlinear_fit.hpp"

namespace granum::hardin {

namespace {

std::mutex handler_mutex;
std::size_t users = 0; ///< objects of GslErrorsReturned that exist
gsl_error_handler_t* handler_before = nullptr;

} // namespace

GslErrorsReturned::GslErrorsReturned() {
  const std::lock_guard lock(handler_mutex);
  if (users++ == 0)
    handler_before = gsl_set_error_handler_off();
}

GslErrorsReturned::~GslErrorsReturned() {
  const std::lock_guard lock(handler_mutex);
  if (--users == 0)
    gsl_set_error_handler(handler_before);
}

void require_success(int code, const std::string& step) {
  if (code != GSL_SUCCESS)
    throw NotConverged(step + " failed: " + gsl_strerror(code));
}

GslVector allocated_vector(std::size_t size) {
  return required(GslVector(gsl_vector_alloc(size), gsl_vector_free), size);
}

GslMatrix allocated_matrix(std::size_t rows, std::size_t columns) {
  return required(GslMatrix(gsl_matrix_alloc(rows, columns), gsl_matrix_free), rows);
}

LinearWorkspace allocated_linear_workspace(std::size_t rows, std::size_t parameters) {
  return required(LinearWorkspace(gsl_multifit_linear_alloc(rows, parameters), gsl_multifit_linear_free),
                  rows);
}

namespace {

using Workspace = std::unique_ptr<gsl_multifit_nlinear_workspace, decltype(&gsl_multifit_nlinear_free)>;

/// The problem, and an exception of one of its functions, which must not pass through code in C.
struct Called {
  const NonlinearProblem& problem;
  std::exception_ptr thrown = nullptr;
};

template <class Out, class Function>
int call(const gsl_vector* theta, std::exception_ptr& thrown, const Function& function, Out* out) {
  try {
    copy_to(function(vector_of(theta)), out);
    return GSL_SUCCESS;
  } catch (...) {
    thrown = std::current_exception();
    return GSL_EBADFUNC;
  }
}

int residuals_for_gsl(const gsl_vector* theta, void* called, gsl_vector* out) {
  auto& [problem, thrown] = *static_cast<Called*>(called);
  return call(theta, thrown, problem.residuals, out);
}

int jacobian_for_gsl(const gsl_vector* theta, void* called, gsl_matrix* out) {
  auto& [problem, thrown] = *static_cast<Called*>(called);
  return call(theta, thrown, problem.jacobian, out);
}

/// Whether the residuals vanish to rounding or are perpendicular to every column of the Jacobian: no step
/// helps.
bool stationary(const NonlinearProblem& problem, const Eigen::VectorXd& theta) {
  const Eigen::VectorXd r = problem.residuals(theta);
  const double root_n = std::sqrt(static_cast<double>(r.size()));
  if (r.norm() <= 1e-13 * root_n)
    return true;
  const Eigen::MatrixXd j = problem.jacobian(theta);
  const Eigen::VectorXd cosines =
      (j.transpose() * r).array() / (j.colwise().norm().transpose().array() * r.norm());
  return cosines.cwiseAbs().maxCoeff() <= 1e-8;
}

void rethrow(const Called& called) {
  if (called.thrown)
    std::rethrow_exception(called.thrown);
}

} // namespace

NonlinearSolution solve(const NonlinearProblem& problem, const Eigen::VectorXd& start,
                        std::size_t iteration_limit, const char* what) {
  const GslErrorsReturned guard;
  const auto rows = static_cast<std::size_t>(problem.residuals(start).size());
  const auto parameters = static_cast<std::size_t>(start.size());
  gsl_multifit_nlinear_parameters settings = gsl_multifit_nlinear_default_parameters();
  settings.trs = gsl_multifit_nlinear_trs_lm;
  const Workspace workspace =
      required(Workspace(gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &settings, rows, parameters),
                         gsl_multifit_nlinear_free),
               rows);

  Called called{problem};
  gsl_multifit_nlinear_fdf system{};
  system.f = residuals_for_gsl;
  system.df = jacobian_for_gsl;
  system.n = rows;
  system.p = parameters;
  system.params = &called;
  const gsl_vector_const_view first = gsl_vector_const_view_array(start.data(), parameters);
  const int begun = gsl_multifit_nlinear_init(&first.vector, &system, workspace.get());
  rethrow(called);
  require_success(begun, std::string("the start of a fit of ") + what);

  int reason = 0;
  const double step = 1e-13, gradient = 1e-15, change = 0; // to rounding: a row is cheap
  const int outcome = gsl_multifit_nlinear_driver(iteration_limit, step, gradient, change, nullptr, nullptr,
                                                  &reason, workspace.get());
  rethrow(called);
  NonlinearSolution solution{FitStatus::converged, gsl_multifit_nlinear_niter(workspace.get()),
                             vector_of(gsl_multifit_nlinear_position(workspace.get()))};
  // at the optimum the driver may find no better step and call that a failure
  if (outcome != GSL_SUCCESS && !stationary(problem, solution.theta))
    solution.status =
        solution.iterations >= iteration_limit ? FitStatus::iteration_limit : FitStatus::no_progress;
  return solution;
}

} // namespace granum::hardin
