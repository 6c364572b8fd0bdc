// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>

#include <algorithm>
#include <vector>

#include <granum/hardin/fit.hpp>

#include "bindings.hpp"
#include "members.hpp"
#include "rows.hpp"
#include "shared_keywords.hpp"

namespace granum::python {

namespace {

Keyword function_keyword() {
  std::string names;
  for (const hardin::VoidRatioFunction function : hardin::all_void_ratio_functions())
    names += (names.empty() ? "" : ", ") + std::string(hardin::name(function));
  return with_default("void_ratio_function", "'hardin-richart-round'", "str", "f(e): one of " + names + ".");
}

hardin::VoidRatioFunction function_of(const Arguments& a, std::size_t at) {
  return a.given(at) ? hardin::void_ratio_function(a.text(at)) : hardin::Equation{}.void_ratio_function;
}

std::vector<Keyword> stress_keywords() {
  return {column("stress_i", ""),
          column("stress_j",
                 "Effective stresses along the directions of propagation and of polarisation, > 0 "
                 "[Pa]."),
          of_input(estimate::Input::void_ratio)};
}

constexpr std::pair<const char*, hardin::Weights> all_weights[] = {{"relative", hardin::Weights::relative},
                                                                   {"absolute", hardin::Weights::absolute}};

py::object fit(const Arguments& a) {
  enum : std::size_t { atmospheric_pressure = 4, void_ratio_function, weights, sum_only };
  std::vector<hardin::MeasuredModulus> rows;
  Columns(columns_of(a)).for_each([&](std::size_t, const double* x) {
    rows.push_back(
        {.shear_modulus = x[0], .state = {.stress_i = x[1], .stress_j = x[2], .void_ratio = x[3]}});
  });
  hardin::FitOptions options{.atmospheric_pressure = a.number(atmospheric_pressure),
                             .void_ratio_function = function_of(a, void_ratio_function)};
  if (a.given(weights))
    options.weights = a.choice(weights, all_weights);
  return py::cast(unlocked([&, sum = a.flag(sum_only)] {
    return (sum ? hardin::fit_exponent_sum(rows, options) : hardin::fit(rows, options)).fit();
  }));
}

py::array covariance(const hardin::Fit& fit) {
  const auto count = static_cast<py::ssize_t>(fit.covariance.size());
  py::array_t<double> out({count, count});
  double* to = out.mutable_data();
  for (const std::vector<double>& row : fit.covariance)
    to = std::copy(row.begin(), row.end(), to);
  return out;
}

void bind_fit(py::module_& module) {
  using hardin::Fit;
  ResultClass<Fit>(module, "Fit", "G_ij = C p_a f(e) (sigma_i/p_a)^m (sigma_j/p_a)^n, fitted.")
      .show("coefficient", "C [1].", &Fit::coefficient)
      .show("exponent_i", "m [1]; None if only the sum was fitted.", &Fit::exponent_i)
      .show("exponent_j", "n [1]; None if only the sum was fitted.", &Fit::exponent_j)
      .show("exponent_sum", "s = m + n [1], with the covariance of both.", &Fit::exponent_sum)
      .show("parameters", "C, m, n or C, s: the order of the covariance.", &Fit::parameters)
      .show("covariance", "From the scatter of the residuals, (P, P).", &covariance)
      .show("r_squared", "R^2 of the weighted values; None if all are equal [1].", &Fit::r_squared)
      .show("residuals", "Measured minus fitted G, one per row [Pa], (N,).",
            [](const Fit& f) { return array_of(f.residuals); })
      .show("rms_relative_residual", "Root mean square of G over fitted G minus 1 [1].",
            &Fit::rms_relative_residual)
      .show("degrees_of_freedom", "Rows minus parameters.", &Fit::degrees_of_freedom)
      .show_notes();
  define(module, "fit",
         std::vector{column("shear_modulus", "Measured G_ij > 0, one per row [Pa].")} + stress_keywords() +
             std::vector{
                 required("atmospheric_pressure", "float",
                          "Reference pressure p_a > 0 of C [Pa]; it has no default."),
                 function_keyword(),
                 with_default("weights", "'relative'", "{\"relative\", \"absolute\"}",
                              "Residuals of ln G, or of G."),
                 with_default("sum_only", "False", "bool",
                              "Fit only C and s: for paths of one stress ratio, which do not determine m "
                              "and n separately.")},
         {"Hardin's equation fitted to measured moduli: C, m, n with their covariance.", "Fit",
          "For an invalid row, too few rows, or stresses that do not determine m and n separately.",
          "[HardinRichart1963] [Chung2014]", "hardin::fit", "hardin/fit.hpp",
          "NotConverged\n    If the iteration does not converge.\n"},
         &fit);
}

} // namespace

void bind_hardin(py::module_& module) {
  bind_fit(module);
  define(module, "hardin",
         std::vector{column("coefficient", "C > 0 [1]."), column("exponent_i", ""),
                     column("exponent_j", "m and n [1]."),
                     column("atmospheric_pressure", "Reference pressure p_a > 0 of C [Pa].")} +
             stress_keywords() + std::vector{function_keyword()},
         {"G_ij = C p_a f(e) (sigma_i/p_a)^m (sigma_j/p_a)^n, Hardin's equation.",
          "float or ndarray\n    G_ij [Pa], of the broadcast shape.",
          "For the first number out of range, or another function.", "[HardinRichart1963] [Chung2014]",
          "hardin::shear_modulus", "hardin/equation.hpp"},
         [](const Arguments& a) {
           return numbers_of_rows(a, [function = function_of(a, 7)](const double* x) {
             return hardin::shear_modulus({.coefficient = x[0],
                                           .exponent_i = x[1],
                                           .exponent_j = x[2],
                                           .atmospheric_pressure = x[3],
                                           .void_ratio_function = function},
                                          {.stress_i = x[4], .stress_j = x[5], .void_ratio = x[6]});
           });
         });
}

} // namespace granum::python
