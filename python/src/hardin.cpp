// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <vector>

#include <granum/core/error.hpp>
#include <granum/hardin/fit.hpp>

#include "bindings.hpp"
#include "docstrings.hpp"
#include "keywords.hpp"
#include "rows.hpp"

namespace granum::python {

namespace {

std::string names_of_functions() {
  std::string text;
  for (const hardin::VoidRatioFunction function : hardin::all_void_ratio_functions())
    text += (text.empty() ? "" : ", ") + std::string(hardin::name(function));
  return text;
}

hardin::VoidRatioFunction function_of(const Arguments& a, std::size_t at) {
  return a.given(at) ? hardin::void_ratio_function(a.text(at)) : hardin::Equation{}.void_ratio_function;
}

py::object equation(const Arguments& a) {
  const hardin::VoidRatioFunction function = function_of(a, 7);
  const char* const names[] = {"coefficient", "exponent_i", "exponent_j", "atmospheric_pressure",
                               "stress_i",    "stress_j",   "void_ratio"};
  std::vector<Argument> columns;
  for (std::size_t k = 0; k < std::size(names); ++k)
    columns.push_back({names[k], a[k]});
  return computed(answer_rows<double>(columns, true, 0.0,
                                      [function](const double* x, Notes&) {
                                        return hardin::shear_modulus(
                                            {.coefficient = x[0],
                                             .exponent_i = x[1],
                                             .exponent_j = x[2],
                                             .atmospheric_pressure = x[3],
                                             .void_ratio_function = function},
                                            {.stress_i = x[4], .stress_j = x[5], .void_ratio = x[6]});
                                      }),
                  [](double modulus) { return modulus; });
}

hardin::Weights weights_of(const std::string& name) {
  if (name == "relative")
    return hardin::Weights::relative;
  if (name == "absolute")
    return hardin::Weights::absolute;
  throw InvalidArgument("weights is one of relative, absolute, not " + name);
}

/// Places of the keywords of fit().
namespace fit_keyword {
enum : std::size_t {
  shear_modulus,
  stress_i,
  stress_j,
  void_ratio,
  atmospheric_pressure,
  void_ratio_function,
  weights,
  sum_only
};
} // namespace fit_keyword

py::object fit(const Arguments& a) {
  const Argument columns[] = {{"shear_modulus", a[fit_keyword::shear_modulus]},
                              {"stress_i", a[fit_keyword::stress_i]},
                              {"stress_j", a[fit_keyword::stress_j]},
                              {"void_ratio", a[fit_keyword::void_ratio]}};
  std::vector<hardin::MeasuredModulus> rows;
  Columns(columns).for_each([&](std::size_t, const double* x) {
    rows.push_back(
        {.shear_modulus = x[0], .state = {.stress_i = x[1], .stress_j = x[2], .void_ratio = x[3]}});
  });
  hardin::FitOptions options{.atmospheric_pressure =
                                 number_of("atmospheric_pressure", a[fit_keyword::atmospheric_pressure]),
                             .void_ratio_function = function_of(a, fit_keyword::void_ratio_function)};
  if (a.given(fit_keyword::weights))
    options.weights = weights_of(a.text(fit_keyword::weights));
  const bool sum_only = a.flag(fit_keyword::sum_only);
  return py::cast(unlocked([&] {
    return (sum_only ? hardin::fit_exponent_sum(rows, options) : hardin::fit(rows, options)).fit();
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
  py::class_<Fit>(module, "Fit", "G_ij = C p_a f(e) (sigma_i/p_a)^m (sigma_j/p_a)^n, fitted.")
      .def_readonly("coefficient", &Fit::coefficient, "C [1].")
      .def_readonly("exponent_i", &Fit::exponent_i, "m [1]; None if only the sum was fitted.")
      .def_readonly("exponent_j", &Fit::exponent_j, "n [1]; None if only the sum was fitted.")
      .def_readonly("exponent_sum", &Fit::exponent_sum, "s = m + n [1], with the covariance of both.")
      .def_readonly("parameters", &Fit::parameters, "C, m, n or C, s: the order of the covariance.")
      .def_property_readonly("covariance", &covariance, "From the scatter of the residuals, (P, P).")
      .def_readonly("r_squared", &Fit::r_squared, "R^2 of the weighted values; None if all are equal [1].")
      .def_property_readonly(
          "residuals",
          [](const Fit& f) {
            return py::array_t<double>(static_cast<py::ssize_t>(f.residuals.size()), f.residuals.data());
          },
          "Measured minus fitted G, one per row [Pa], (N,).")
      .def_readonly("rms_relative_residual", &Fit::rms_relative_residual,
                    "Root mean square of G over fitted G minus 1 [1].")
      .def_readonly("degrees_of_freedom", &Fit::degrees_of_freedom, "Rows minus parameters.")
      .def_property_readonly(
          "notes", [](const Fit& f) { return f.validity.notes; }, "Notes, one sentence each.");
  define(module, {"fit",
                  {{"shear_modulus"},
                   {"stress_i"},
                   {"stress_j"},
                   {"void_ratio"},
                   {"atmospheric_pressure"},
                   {"void_ratio_function", "'hardin-richart-round'"},
                   {"weights", "'relative'"},
                   {"sum_only", "False"}},
                  &fit,
                  std::string(R"(Hardin's equation fitted to measured moduli: C, m, n with their covariance.

Parameters
----------
shear_modulus : array_like
    Measured G_ij > 0, one per row [Pa].
stress_i, stress_j : array_like
    Effective stresses along the directions of propagation and of polarisation, > 0 [Pa].
void_ratio : array_like
    e of each row [1].
atmospheric_pressure : float
    Reference pressure p_a > 0 of C [Pa]; it has no default.
void_ratio_function : str
    f(e): one of )") + names_of_functions() +
                      R"(.
weights : {"relative", "absolute"}
    Residuals of ln G, or of G.
sum_only : bool
    Fit only C and s: for paths of one stress ratio, which do not determine m and n separately.

Returns
-------
Fit

Raises
------
InvalidArgument
    For an invalid row, too few rows, or stresses that do not determine m and n separately.
NotConverged
    If the iteration does not converge.
)" + notes("[HardinRichart1963] [Chung2014]", "hardin::fit", "hardin/fit.hpp")});
}

} // namespace

void bind_hardin(py::module_& module) {
  bind_fit(module);
  define(module,
         {"hardin",
          {{"coefficient"},
           {"exponent_i"},
           {"exponent_j"},
           {"atmospheric_pressure"},
           {"stress_i"},
           {"stress_j"},
           {"void_ratio"},
           {"void_ratio_function", "'hardin-richart-round'"}},
          &equation,
          std::string(R"(G_ij = C p_a f(e) (sigma_i/p_a)^m (sigma_j/p_a)^n, Hardin's equation.

Parameters
----------
coefficient : array_like
    C > 0 [1].
exponent_i, exponent_j : array_like
    m and n [1].
atmospheric_pressure : array_like
    Reference pressure p_a > 0 of C [Pa].
stress_i, stress_j : array_like
    Effective stresses along the directions of propagation and of polarisation, > 0 [Pa].
void_ratio : array_like
    e > 0 [1].
void_ratio_function : str
    f(e): one of )") +
              names_of_functions() + R"(.

Returns
-------
float or ndarray
    G_ij [Pa], of the broadcast shape.
)" + raises_invalid("For the first number out of range, or another function.") +
              notes("[HardinRichart1963] [Chung2014]", "hardin::shear_modulus", "hardin/equation.hpp")});
}

} // namespace granum::python
