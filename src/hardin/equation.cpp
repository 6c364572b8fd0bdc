// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/hardin/equation.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <granum/core/error.hpp>
#include <granum/sands/known_sands.hpp>

#include "gsl.hpp"

namespace granum::hardin {

double void_ratio_value(VoidRatioFunction function, double void_ratio) {
  const double e = require_positive("void_ratio", void_ratio);
  switch (function) {
  case VoidRatioFunction::hardin_richart_round:
    return sands::hardin_richart_factor(2.17, e);
  case VoidRatioFunction::hardin_richart_angular:
    return sands::hardin_richart_factor(2.97, e);
  case VoidRatioFunction::power_1_3:
    return std::pow(e, -1.3);
  case VoidRatioFunction::hardin_blandford:
    return 1 / (0.3 + 0.7 * e * e);
  case VoidRatioFunction::none:
    return 1;
  }
  throw InvalidArgument("void-ratio function is not one of the known ones");
}

std::string_view name(VoidRatioFunction function) {
  switch (function) {
  case VoidRatioFunction::hardin_richart_round:
    return "hardin-richart-round";
  case VoidRatioFunction::hardin_richart_angular:
    return "hardin-richart-angular";
  case VoidRatioFunction::power_1_3:
    return "power-1.3";
  case VoidRatioFunction::hardin_blandford:
    return "hardin-blandford";
  case VoidRatioFunction::none:
    return "none";
  }
  throw InvalidArgument("void-ratio function is not one of the known ones");
}

std::vector<VoidRatioFunction> all_void_ratio_functions() {
  return {VoidRatioFunction::hardin_richart_round, VoidRatioFunction::hardin_richart_angular,
          VoidRatioFunction::power_1_3, VoidRatioFunction::hardin_blandford, VoidRatioFunction::none};
}

VoidRatioFunction void_ratio_function(std::string_view wanted) {
  std::string known;
  for (const VoidRatioFunction function : all_void_ratio_functions()) {
    if (name(function) == wanted)
      return function;
    known += (known.empty() ? "" : ", ") + std::string(name(function));
  }
  throw InvalidArgument("void-ratio function '" + std::string(wanted) + "' is unknown; known are " + known);
}

double shear_modulus(const Equation& equation, const SoilState& state) {
  const double pa = require_positive("atmospheric_pressure", equation.atmospheric_pressure, "Pa");
  const double c = require_positive("coefficient", equation.coefficient);
  const double m = require_finite("exponent_i", equation.exponent_i);
  const double n = require_finite("exponent_j", equation.exponent_j);
  const double si = require_positive("stress_i", state.stress_i, "Pa");
  const double sj = require_positive("stress_j", state.stress_j, "Pa");
  return c * pa * void_ratio_value(equation.void_ratio_function, state.void_ratio) * std::pow(si / pa, m) *
         std::pow(sj / pa, n);
}

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
