// SPDX-License-Identifier: GPL-3.0-or-later
// Non-linear least squares with exact derivatives, and a covariance that knows that the rows of one group
// err together.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include <Eigen/LU>
#include <gsl/gsl_blas.h>
#include <gsl/gsl_linalg.h>
#include <gsl/gsl_multifit_nlinear.h>
#include <unsupported/Eigen/AutoDiff>

namespace relaxation {

template <int n>
using Dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, n, 1>>;
template <class T, int n>
using Numbers = std::array<T, static_cast<std::size_t>(n)>;

/// One measured value: residual = model - target, each times the weight.
template <int n>
struct Observation {
  std::function<Dual<n>(const Numbers<Dual<n>, n>&)> model;
  double target = 0;
  double weight = 1;
  std::string group; ///< whose rows err together
};

template <int n>
struct Fit {
  Numbers<double, n> coefficients;
  Eigen::Matrix<double, n, n> covariance;
};

namespace detail {

template <int n>
Dual<n> residual(const Observation<n>& o, const Numbers<double, n>& c) {
  Numbers<Dual<n>, n> duals;
  for (int k = 0; k < n; ++k)
    duals[static_cast<std::size_t>(k)] = Dual<n>(c[static_cast<std::size_t>(k)], n, k);
  return o.weight * (o.model(duals) - o.target);
}

template <int n>
using Observations = std::vector<Observation<n>>;

template <int n>
int fill(const gsl_vector* x, void* data, gsl_vector* values, gsl_matrix* slopes) {
  const auto& rows = *static_cast<const Observations<n>*>(data);
  Numbers<double, n> c;
  for (std::size_t k = 0; k < c.size(); ++k)
    c[k] = gsl_vector_get(x, k);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Dual<n> f = residual<n>(rows[i], c);
    // A step that leads out of the model's domain counts as a very bad one.
    if (values != nullptr)
      gsl_vector_set(values, i, std::isfinite(f.value()) ? f.value() : 1e3);
    for (int k = 0; slopes != nullptr && k < n; ++k)
      gsl_matrix_set(slopes, i, static_cast<std::size_t>(k), f.derivatives()[k]);
  }
  return GSL_SUCCESS;
}
template <int n>
int fill_values(const gsl_vector* x, void* data, gsl_vector* values) {
  return fill<n>(x, data, values, nullptr);
}
template <int n>
int fill_slopes(const gsl_vector* x, void* data, gsl_matrix* slopes) {
  return fill<n>(x, data, nullptr, slopes);
}

/// Sums over the rows: J'J, and of each group its share of J'f.
struct NormalSums {
  Eigen::MatrixXd normal;
  std::map<std::string, Eigen::VectorXd> shares;
};

template <int n>
NormalSums normal_sums(const Observations<n>& rows, const Numbers<double, n>& c) {
  NormalSums sums{.normal = Eigen::MatrixXd::Zero(n, n), .shares = {}};
  for (const Observation<n>& o : rows) {
    const Dual<n> f = residual<n>(o, c);
    Eigen::VectorXd& share = sums.shares.try_emplace(o.group, Eigen::VectorXd::Zero(n)).first->second;
    for (int k = 0; k < n; ++k) {
      share[k] += f.value() * f.derivatives()[k];
      for (int j = 0; j < n; ++j)
        sums.normal(j, k) += f.derivatives()[j] * f.derivatives()[k];
    }
  }
  return sums;
}

/// (J'J)^-1 (sum over groups of g g') (J'J)^-1 with g the group's share of J'f: right also when the
/// rows of a group are correlated.                                                       [LiangZeger1986]
inline Eigen::MatrixXd clustered_covariance(const NormalSums& sums) {
  const Eigen::Index n = sums.normal.cols();
  Eigen::MatrixXd scatter = Eigen::MatrixXd::Zero(n, n);
  for (const auto& [name, share] : sums.shares)
    scatter += share * share.transpose();
  Eigen::MatrixXd inverse = sums.normal;
  const auto size = static_cast<std::size_t>(n);
  gsl_matrix_view view =
      gsl_matrix_view_array(inverse.data(), size, size); // by GSL: Eigen's takes long to compile
  gsl_linalg_cholesky_decomp1(&view.matrix);
  gsl_linalg_cholesky_invert(&view.matrix);
  const double groups = static_cast<double>(sums.shares.size());
  return groups / (groups - 1) * inverse.lazyProduct(scatter).eval().lazyProduct(inverse);
}

/// A row that is no number would count as a bad one wherever the fit goes, which then arrives nowhere.
template <int n>
void require_finite(const Observations<n>& rows, const Numbers<double, n>& start) {
  for (const Observation<n>& row : rows)
    if (!std::isfinite(residual<n>(row, start).value()))
      throw std::invalid_argument("the fit cannot begin: a row of " + row.group +
                                  " is no number there, target " + std::to_string(row.target));
}

/// Steps until they or the slopes are tiny, or until ten of them lower the sum of squares by no more than
/// 1e-10 of it: steps stay finite where a row lies on the edge of a model that is bent there.
inline int arrive(gsl_multifit_nlinear_workspace* work) {
  double before = 0;
  int status = GSL_EMAXITER;
  for (int round = 0; round < 50 && status == GSL_EMAXITER; ++round) {
    int info = 0;
    status = gsl_multifit_nlinear_driver(10, 1e-10, 1e-12, 0, nullptr, nullptr, &info, work);
    const gsl_vector* residuals = gsl_multifit_nlinear_residual(work);
    double sum = 0;
    gsl_blas_ddot(residuals, residuals, &sum);
    if (status == GSL_EMAXITER && round > 0 && before - sum <= 1e-10 * sum)
      status = GSL_SUCCESS;
    before = sum;
  }
  return status;
}

} // namespace detail

/// \throws   std::invalid_argument if the residual of a row is not finite at the start
/// \throws   std::runtime_error if the fit does not arrive
template <int n>
Fit<n> least_squares(std::vector<Observation<n>> rows, const Numbers<double, n>& start) {
  detail::require_finite<n>(rows, start);
  gsl_multifit_nlinear_fdf system{};
  system.f = detail::fill_values<n>;
  system.df = detail::fill_slopes<n>;
  system.n = rows.size();
  system.p = n;
  system.params = &rows;
  gsl_multifit_nlinear_parameters parameters = gsl_multifit_nlinear_default_parameters();
  gsl_multifit_nlinear_workspace* work =
      gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &parameters, rows.size(), n);
  const gsl_vector_const_view first = gsl_vector_const_view_array(start.data(), n);
  gsl_multifit_nlinear_init(&first.vector, &system, work);
  const int status = detail::arrive(work);
  Fit<n> fit;
  for (std::size_t k = 0; k < fit.coefficients.size(); ++k)
    fit.coefficients[k] = gsl_vector_get(gsl_multifit_nlinear_position(work), k);
  gsl_multifit_nlinear_free(work);
  if (status != GSL_SUCCESS)
    throw std::runtime_error(std::string("the fit did not converge: ") + gsl_strerror(status));
  fit.covariance = detail::clustered_covariance(detail::normal_sums<n>(rows, fit.coefficients));
  return fit;
}

} // namespace relaxation
