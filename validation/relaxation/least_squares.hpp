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

#include <gsl/gsl_blas.h>
#include <gsl/gsl_linalg.h>
#include <gsl/gsl_multifit_nlinear.h>

namespace relaxation {

template <class T, int n>
using Numbers = std::array<T, static_cast<std::size_t>(n)>;

/// A number with its derivatives by n others.
template <int n>
struct Dual {
  double value = 0;
  Numbers<double, n> slopes{};

  Dual() = default;
  Dual(double constant) : value(constant) {} // NOLINT(google-explicit-constructor): formulas mix both
  /// The number by which the slope at that place is.
  Dual(double at, std::size_t place) : value(at) { slopes[place] = 1; }

  /// The function of this number that has that value, and that slope by it.
  [[nodiscard]] Dual chained(double result, double slope) const {
    Dual out(result);
    for (std::size_t k = 0; k < slopes.size(); ++k)
      out.slopes[k] = slopes[k] * slope;
    return out;
  }
  friend Dual operator+(const Dual& a, const Dual& b) {
    Dual out(a.value + b.value);
    for (std::size_t k = 0; k < a.slopes.size(); ++k)
      out.slopes[k] = a.slopes[k] + b.slopes[k];
    return out;
  }
  friend Dual operator*(const Dual& a, const Dual& b) {
    Dual out(a.value * b.value);
    for (std::size_t k = 0; k < a.slopes.size(); ++k)
      out.slopes[k] = a.slopes[k] * b.value + b.slopes[k] * a.value;
    return out;
  }
  Dual operator-() const { return chained(-value, -1); }
  friend Dual operator-(const Dual& a, const Dual& b) { return a + -b; }
  friend Dual operator/(const Dual& a, const Dual& b) {
    Dual out = a * b.chained(1 / b.value, -1 / (b.value * b.value));
    out.value = a.value / b.value; // to the last digit
    return out;
  }
  friend auto operator<=>(const Dual& a, const Dual& b) { return a.value <=> b.value; }
  friend bool operator==(const Dual& a, const Dual& b) { return a.value == b.value; }
  friend Dual exp(const Dual& a) { return a.chained(std::exp(a.value), std::exp(a.value)); }
  friend Dual log(const Dual& a) { return a.chained(std::log(a.value), 1 / a.value); }
  friend Dual sqrt(const Dual& a) { return a.chained(std::sqrt(a.value), 0.5 / std::sqrt(a.value)); }
};

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
  Numbers<double, n> coefficients{};
  Numbers<Numbers<double, n>, n> covariance{};

  [[nodiscard]] double error(std::size_t k) const { return std::sqrt(covariance[k][k]); }
  /// The coefficients as numbers that slopes are by.
  [[nodiscard]] Numbers<Dual<n>, n> duals() const { return duals_of(coefficients); }
  [[nodiscard]] static Numbers<Dual<n>, n> duals_of(const Numbers<double, n>& values) {
    Numbers<Dual<n>, n> duals;
    for (std::size_t k = 0; k < values.size(); ++k)
      duals[k] = Dual<n>(values[k], k);
    return duals;
  }
};

namespace detail {

template <int n>
using Observations = std::vector<Observation<n>>;

template <int n>
Dual<n> residual(const Observation<n>& o, const Numbers<double, n>& c) {
  return o.weight * (o.model(Fit<n>::duals_of(c)) - o.target);
}

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
      gsl_vector_set(values, i, std::isfinite(f.value) ? f.value : 1e3);
    for (std::size_t k = 0; slopes != nullptr && k < c.size(); ++k)
      gsl_matrix_set(slopes, i, k, f.slopes[k]);
  }
  return GSL_SUCCESS;
}

/// (J'J)^-1 (sum over groups of g g') (J'J)^-1 with g the group's share of J'f: right also when the
/// rows of a group are correlated.                                                       [LiangZeger1986]
template <int n>
void fill_covariance(const Observations<n>& rows, Fit<n>& fit) {
  using Sums = Numbers<double, n>;
  Numbers<Sums, n> normal{};
  std::map<std::string, Sums> shares;
  for (const Observation<n>& o : rows) {
    const Dual<n> f = residual<n>(o, fit.coefficients);
    Sums& share = shares[o.group];
    for (std::size_t k = 0; k < share.size(); ++k) {
      share[k] += f.value * f.slopes[k];
      for (std::size_t j = 0; j < share.size(); ++j)
        normal[j][k] += f.slopes[j] * f.slopes[k];
    }
  }
  gsl_matrix_view matrix = gsl_matrix_view_array(normal[0].data(), n, n);
  gsl_linalg_cholesky_decomp1(&matrix.matrix);
  const double groups = static_cast<double>(shares.size());
  for (auto& [name, share] : shares) {
    gsl_vector_view view = gsl_vector_view_array(share.data(), n);
    gsl_linalg_cholesky_svx(&matrix.matrix, &view.vector);
    for (std::size_t k = 0; k < share.size(); ++k)
      for (std::size_t j = 0; j < share.size(); ++j)
        fit.covariance[j][k] += groups / (groups - 1) * share[j] * share[k];
  }
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

/// \throws   std::invalid_argument if the residual of a row is not finite at the start: it would count as a
///           bad one wherever the fit goes
/// \throws   std::runtime_error if the fit does not arrive
template <int n>
Fit<n> least_squares(std::vector<Observation<n>> rows, const Numbers<double, n>& start) {
  for (const Observation<n>& row : rows)
    if (!std::isfinite(detail::residual<n>(row, start).value))
      throw std::invalid_argument("the fit cannot begin: a row of " + row.group +
                                  " is no number there, target " + std::to_string(row.target));
  gsl_multifit_nlinear_fdf system{};
  system.f = [](const gsl_vector* x, void* data, gsl_vector* f) {
    return detail::fill<n>(x, data, f, nullptr);
  };
  system.df = [](const gsl_vector* x, void* data, gsl_matrix* J) {
    return detail::fill<n>(x, data, nullptr, J);
  };
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
  detail::fill_covariance<n>(rows, fit);
  return fit;
}

} // namespace relaxation
