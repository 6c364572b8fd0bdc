// SPDX-License-Identifier: GPL-3.0-or-later
// Notation: ln G = base + X theta, with base = ln(p_a f(e)), theta = (ln C, m, n) and a row (1, x, y) of the
// design X, x = ln(sigma_i/p_a), y = ln(sigma_j/p_a); or theta = (ln C, s) and a row (1, (x+y)/2).
#include <granum/hardin/fit.hpp>

#include <algorithm>
#include <cmath>

#include <Eigen/Core>
#include <gsl/gsl_linalg.h>

#include <granum/core/error.hpp>
#include <granum/core/stop.hpp>
#include <granum/core/text.hpp>

#include "gsl.hpp"
#include "nonlinear_fit.hpp"

namespace granum::hardin {

namespace {

/// Scatter of ln stress across a path, relative to that along it, below which m and n are one number.
constexpr double smallest_scatter = 1e-3;
/// Correlation of m and n from which on a note warns.
constexpr double high_correlation = 0.99;

struct Problem {
  Eigen::MatrixXd design;
  Eigen::VectorXd base;
  Eigen::VectorXd measured; ///< G [Pa]
  Weights weights;
  double scale; ///< of G, so that residuals are of order 1 whatever the unit [Pa]

  [[nodiscard]] Eigen::VectorXd modulus(const Eigen::VectorXd& theta) const {
    return (base + design * theta).array().exp();
  }
  /// Residuals in the space of the weights, pure numbers.
  [[nodiscard]] Eigen::VectorXd residuals(const Eigen::VectorXd& theta) const {
    if (weights == Weights::relative)
      return base + design * theta - measured.array().log().matrix();
    return (modulus(theta) - measured) / scale;
  }
  [[nodiscard]] Eigen::MatrixXd jacobian(const Eigen::VectorXd& theta) const {
    if (weights == Weights::relative)
      return design;
    return (modulus(theta) / scale).asDiagonal() * design;
  }
};

struct LinearFit {
  Eigen::VectorXd theta;
  Eigen::MatrixXd inverse_information; ///< (X^T X)^-1
};

/// Least squares of X theta = y, by singular values of X with balanced columns.
LinearFit least_squares(const Eigen::MatrixXd& x, const Eigen::VectorXd& y) {
  const GslErrorsReturned guard;
  const auto rows = static_cast<std::size_t>(x.rows()), parameters = static_cast<std::size_t>(x.cols());
  const GslMatrix matrix = gsl_matrix_of(x), covariance = allocated_matrix(parameters, parameters);
  const GslVector measured = allocated_vector(rows), weights = allocated_vector(rows);
  const GslVector theta = allocated_vector(parameters);
  copy_to(y, measured.get());
  gsl_vector_set_all(weights.get(), 1); // with weights GSL leaves the scatter out of the covariance
  const LinearWorkspace workspace = allocated_linear_workspace(rows, parameters);
  double square_sum = 0;
  require_success(gsl_multifit_wlinear(matrix.get(), weights.get(), measured.get(), theta.get(),
                                       covariance.get(), &square_sum, workspace.get()),
                  "a fit by linear least squares");
  LinearFit fit{vector_of(theta.get()), Eigen::MatrixXd(x.cols(), x.cols())};
  for (Eigen::Index i = 0; i < x.cols(); ++i)
    for (Eigen::Index j = 0; j < x.cols(); ++j)
      fit.inverse_information(i, j) =
          gsl_matrix_get(covariance.get(), static_cast<std::size_t>(i), static_cast<std::size_t>(j));
  return fit;
}

NonlinearSolution solve(const Problem& problem, const Eigen::VectorXd& start, std::size_t iteration_limit) {
  return hardin::solve({[&](const Eigen::VectorXd& theta) {
                          stop_point();
                          return problem.residuals(theta);
                        },
                        [&](const Eigen::VectorXd& theta) { return problem.jacobian(theta); }},
                       start, iteration_limit, "Eq. (1)");
}

// --- from rows to the problem, and back
// ------------------------------------------------------------------------------

Problem make_problem(std::span<const MeasuredModulus> rows, const FitOptions& options,
                     Eigen::Index parameters) {
  const double pa = require_positive("atmospheric_pressure", options.atmospheric_pressure, "Pa");
  if (rows.size() <= static_cast<std::size_t>(parameters))
    throw InvalidArgument("a fit of " + std::to_string(parameters) +
                          " parameters with standard errors needs at least " +
                          std::to_string(parameters + 1) + " rows, not " + std::to_string(rows.size()));
  const auto count = static_cast<Eigen::Index>(rows.size());
  Problem problem{Eigen::MatrixXd::Ones(count, parameters), Eigen::VectorXd(count), Eigen::VectorXd(count),
                  options.weights, 1};
  for (Eigen::Index k = 0; k < count; ++k) {
    const MeasuredModulus& row = rows[static_cast<std::size_t>(k)];
    try {
      require_valid(row, options.void_ratio_function);
    } catch (const InvalidArgument& error) {
      throw InvalidArgument("row " + std::to_string(k + 1) + ": " + error.what());
    }
    const double x = std::log(row.state.stress_i / pa), y = std::log(row.state.stress_j / pa);
    if (parameters == 3)
      problem.design.row(k) << 1, x, y;
    else
      problem.design.row(k) << 1, (x + y) / 2;
    problem.base[k] = std::log(pa * void_ratio_value(options.void_ratio_function, row.state.void_ratio));
    problem.measured[k] = row.shear_modulus;
  }
  problem.scale = problem.measured.maxCoeff();
  return problem;
}

/// The two ways in which the stresses of all rows vary in the plane of (ln sigma_i, ln sigma_j).
struct Scatter {
  double along;              ///< root mean square along the main direction
  double across;             ///< and perpendicular to it
  Eigen::Vector2d direction; ///< of the main one
};

Scatter scatter(const Eigen::MatrixXd& design) {
  const Eigen::MatrixXd centred = design.rightCols<2>().rowwise() - design.rightCols<2>().colwise().mean();
  const GslErrorsReturned guard;
  const GslMatrix u = gsl_matrix_of(centred);
  const GslMatrix v = allocated_matrix(2, 2);
  const GslVector singular = allocated_vector(2);
  require_success(gsl_linalg_SV_decomp_jacobi(u.get(), v.get(), singular.get()),
                  "a decomposition into singular values");
  const Eigen::VectorXd root_mean_square =
      vector_of(singular.get()) / std::sqrt(static_cast<double>(design.rows()));
  return {root_mean_square[0],
          root_mean_square[1],
          {gsl_matrix_get(v.get(), 0, 0), gsl_matrix_get(v.get(), 1, 0)}};
}

void require_distinct_exponents(const Eigen::MatrixXd& design) {
  const Scatter s = scatter(design);
  if (s.along < smallest_scatter)
    throw InvalidArgument("all rows have the same stresses: no exponent can be fitted");
  if (s.across >= smallest_scatter * s.along)
    return;
  const bool proportional = std::abs(s.direction[0] - s.direction[1]) < 10 * smallest_scatter;
  throw InvalidArgument(
      proportional
          ? "m and n cannot be separated: sigma_i/sigma_j is the same in all rows, so that only the sum "
            "s = m + n has a meaning; fit s alone, or add rows of another stress ratio"
          : "m and n cannot be separated: the stresses of all rows lie on one line of ln sigma_i against ln "
            "sigma_j; add rows of another stress path");
}

/// Log-linear least squares, exact for relative weights.
Eigen::VectorXd start_of(const Problem& problem) {
  return least_squares(problem.design, problem.measured.array().log().matrix() - problem.base).theta;
}

/// (J^T J)^-1 in ln C and the exponents; it depends on where was measured, not on the scatter.
Eigen::MatrixXd inverse_information(const Problem& problem, const Eigen::VectorXd& theta) {
  return least_squares(problem.jacobian(theta), problem.residuals(theta)).inverse_information;
}

std::optional<double> r_squared(const Problem& problem, const Eigen::VectorXd& theta) {
  Eigen::VectorXd value = problem.measured / problem.scale;
  if (problem.weights == Weights::relative)
    value = value.array().log();
  const double total = (value.array() - value.mean()).square().sum();
  if (!(total > 0))
    return std::nullopt;
  return 1 - problem.residuals(theta).squaredNorm() / total;
}

Fit make_fit(const Problem& problem, const FitOptions& options, const Eigen::VectorXd& theta) {
  Fit fit;
  const double c = std::exp(theta[0]);
  const bool separate = theta.size() == 3;
  fit.degrees_of_freedom = static_cast<std::size_t>(problem.design.rows() - problem.design.cols());
  const double variance =
      problem.residuals(theta).squaredNorm() / static_cast<double>(fit.degrees_of_freedom);
  Eigen::MatrixXd covariance = variance * inverse_information(problem, theta);
  covariance.row(0) *= c; // from ln C to C
  covariance.col(0) *= c;
  const auto estimate = [&](Eigen::Index k, double value) {
    return Measured{value, std::sqrt(covariance(k, k))};
  };
  fit.coefficient = estimate(0, c);
  if (separate) {
    fit.parameters = {"C", "m", "n"};
    fit.exponent_i = estimate(1, theta[1]);
    fit.exponent_j = estimate(2, theta[2]);
    fit.exponent_sum = {theta[1] + theta[2],
                        std::sqrt(std::max(0.0, covariance.bottomRightCorner(2, 2).sum()))};
  } else {
    fit.parameters = {"C", "s"};
    fit.exponent_sum = estimate(1, theta[1]);
  }
  fit.equation = {c, separate ? theta[1] : theta[1] / 2, separate ? theta[2] : theta[1] / 2,
                  options.atmospheric_pressure, options.void_ratio_function};
  for (Eigen::Index i = 0; i < covariance.rows(); ++i)
    fit.covariance.emplace_back(covariance.row(i).begin(), covariance.row(i).end());
  fit.r_squared = r_squared(problem, theta);
  const Eigen::VectorXd fitted = problem.modulus(theta);
  const Eigen::VectorXd residuals = problem.measured - fitted;
  fit.residuals.assign(residuals.begin(), residuals.end());
  fit.rms_relative_residual = std::sqrt((residuals.array() / fitted.array()).square().mean());
  return fit;
}

void note_correlation(const Problem& problem, const Eigen::VectorXd& theta, Validity& validity) {
  const Eigen::MatrixXd c = inverse_information(problem, theta);
  const double correlation = c(1, 2) / std::sqrt(c(1, 1) * c(2, 2));
  if (std::abs(correlation) > high_correlation)
    validity.add("m and n are hard to separate on these stress paths (correlation " +
                 short_text(correlation) + "); their sum s is the better number");
}

void note_falling(const Fit& fit, Validity& validity) {
  const Measured& s = fit.exponent_sum;
  if (s.value < -std::max(2 * s.standard_error, 1e-6)) // moduli without noise have an error of rounding alone
    validity.add("moduli fall as stresses grow, s = " + short_text(s.value) +
                 ": no packing of grains does so; are columns or rows mixed up?");
}

void note_unequal_stresses(std::span<const MeasuredModulus> rows, Validity& validity) {
  const auto log_ratio = [](const MeasuredModulus& row) {
    return std::log(row.state.stress_i / row.state.stress_j);
  };
  const double first = log_ratio(rows.front());
  double spread = 0, offset = 0;
  for (const MeasuredModulus& row : rows) {
    spread = std::max(spread, std::abs(log_ratio(row) - first));
    offset = std::max(offset, std::abs(log_ratio(row)));
  }
  if (spread > 0.01)
    validity.add("sigma_i/sigma_j changes from row to row: s alone assumes m = n = s/2; a fit of m and n "
                 "assumes less");
  else if (offset > 0.01)
    validity.add("sigma_i and sigma_j differ: s does not depend on it, but C assumes m = n = s/2");
}

} // namespace

FitReport::FitReport(FitStatus status, std::size_t iterations, Fit last)
    : status_(status), iterations_(iterations), last_(std::move(last)) {}

const Fit& FitReport::fit() const {
  if (status_ != FitStatus::converged)
    throw NotConverged(std::string("the fit of Eq. (1) did not converge: ") +
                       (status_ == FitStatus::iteration_limit ? "the limit of iterations was reached"
                                                              : "no step makes progress") +
                       " after " + std::to_string(iterations_) + " iterations");
  return last_;
}

void require_valid(const MeasuredModulus& row, VoidRatioFunction function) {
  require_positive("shear_modulus", row.shear_modulus, "Pa");
  require_positive("stress_i", row.state.stress_i, "Pa");
  require_positive("stress_j", row.state.stress_j, "Pa");
  (void)void_ratio_value(function, row.state.void_ratio);
}

FitReport fit(std::span<const MeasuredModulus> rows, const FitOptions& options) {
  Problem problem = make_problem(rows, options, 3);
  require_distinct_exponents(problem.design);
  const NonlinearSolution solution = solve(problem, start_of(problem), options.iteration_limit);
  Fit result = make_fit(problem, options, solution.theta);
  note_correlation(problem, solution.theta, result.validity);
  note_falling(result, result.validity);
  return {solution.status, solution.iterations, std::move(result)};
}

FitReport fit_exponent_sum(std::span<const MeasuredModulus> rows, const FitOptions& options) {
  Problem problem = make_problem(rows, options, 2);
  const Eigen::VectorXd u = problem.design.col(1);
  if (u.maxCoeff() - u.minCoeff() < smallest_scatter)
    throw InvalidArgument("all rows have the same stress: no exponent can be fitted");
  const NonlinearSolution solution = solve(problem, start_of(problem), options.iteration_limit);
  Fit result = make_fit(problem, options, solution.theta);
  note_unequal_stresses(rows, result.validity);
  note_falling(result, result.validity);
  return {solution.status, solution.iterations, std::move(result)};
}

} // namespace granum::hardin
