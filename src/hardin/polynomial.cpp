// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/hardin/polynomial.hpp>

#include <cmath>
#include <memory>

#include <granum/core/error.hpp>
#include <gsl/gsl_multifit.h>

namespace granum::hardin {

Polynomial fit_polynomial(std::span<const double> x, std::span<const double> y, std::size_t degree) {
  const std::size_t terms = degree + 1, points = x.size();
  if (degree > 8)
    throw InvalidArgument("degree", static_cast<double>(degree), "", "[0, 8]");
  if (y.size() != points)
    throw InvalidArgument("fit_polynomial: as many y as x are needed");
  if (points < terms)
    throw InvalidArgument("points", static_cast<double>(points), "", "at least degree + 1");
  using Matrix = std::unique_ptr<gsl_matrix, decltype(&gsl_matrix_free)>;
  using Vector = std::unique_ptr<gsl_vector, decltype(&gsl_vector_free)>;
  const std::unique_ptr<gsl_multifit_linear_workspace, decltype(&gsl_multifit_linear_free)> work(
      gsl_multifit_linear_alloc(points, terms), gsl_multifit_linear_free);
  const Matrix powers(gsl_matrix_alloc(points, terms), gsl_matrix_free),
      covariance(gsl_matrix_alloc(terms, terms), gsl_matrix_free);
  const Vector values(gsl_vector_alloc(points), gsl_vector_free),
      coefficients(gsl_vector_alloc(terms), gsl_vector_free);
  for (std::size_t k = 0; k < points; ++k) {
    for (std::size_t term = 0; term < terms; ++term)
      gsl_matrix_set(powers.get(), k, term, std::pow(x[k], static_cast<double>(term)));
    gsl_vector_set(values.get(), k, y[k]);
  }
  double squares = 0;
  gsl_multifit_linear(powers.get(), values.get(), coefficients.get(), covariance.get(), &squares, work.get());
  Polynomial out;
  for (std::size_t term = 0; term < terms; ++term)
    out.coefficients.push_back(gsl_vector_get(coefficients.get(), term));
  out.rms = std::sqrt(squares / static_cast<double>(points));
  return out;
}

} // namespace granum::hardin
