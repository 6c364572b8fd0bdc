// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/hardin/polynomial.hpp>

#include <algorithm>
#include <cmath>

#include <granum/core/error.hpp>

#include "gsl_errors.hpp"

namespace granum::hardin {

namespace {

/// Beyond it the squares of powers, of y and of their sums do not fit into a double.
constexpr double largest_entry = 1e150;

double checked_entry(const char* name, double value, double entry) {
  if (!(std::abs(entry) <= largest_entry))
    throw InvalidArgument(name, value, "", "numbers that stay within +-1e150, raised to the degree");
  return entry;
}

} // namespace

Polynomial fit_polynomial(std::span<const double> x, std::span<const double> y, std::size_t degree) {
  const std::size_t terms = degree + 1, points = x.size();
  if (degree > 8)
    throw InvalidArgument("degree", static_cast<double>(degree), "", "[0, 8]");
  if (y.size() != points)
    throw InvalidArgument("fit_polynomial: as many y as x are needed");
  if (points < terms)
    throw InvalidArgument("points", static_cast<double>(points), "", "at least degree + 1");
  const GslErrorsReturned guard;
  const LinearWorkspace work = allocated_linear_workspace(points, terms);
  const GslMatrix powers = allocated_matrix(points, terms), covariance = allocated_matrix(terms, terms);
  const GslVector values = allocated_vector(points), coefficients = allocated_vector(terms);
  for (std::size_t k = 0; k < points; ++k) {
    require_finite("x", x[k]);
    for (std::size_t term = 0; term < terms; ++term)
      gsl_matrix_set(powers.get(), k, term,
                     checked_entry("x", x[k], std::pow(x[k], static_cast<double>(term))));
    gsl_vector_set(values.get(), k, checked_entry("y", y[k], y[k]));
  }
  double squares = 0;
  require_success(gsl_multifit_linear(powers.get(), values.get(), coefficients.get(), covariance.get(),
                                      &squares, work.get()),
                  "the fit of a polynomial");
  Polynomial out;
  for (std::size_t term = 0; term < terms; ++term)
    out.coefficients.push_back(gsl_vector_get(coefficients.get(), term));
  out.rms = std::sqrt(squares / static_cast<double>(points));
  if (!std::isfinite(out.rms) || !std::all_of(out.coefficients.begin(), out.coefficients.end(),
                                              [](double c) { return std::isfinite(c); }))
    throw NotConverged("the fit of a polynomial failed: its coefficients are no finite numbers");
  return out;
}

} // namespace granum::hardin
