// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>

#include <algorithm>
#include <vector>

#include <granum/core/references.hpp>
#include <granum/hardin/fit.hpp>
#include <granum/sands/known_sands.hpp>

#include "bindings.hpp"
#include "members.hpp"
#include "moduli.hpp"
#include "rows.hpp"
#include "shared_keywords.hpp"

namespace granum::python {

namespace {

using sands::KnownSand;
using sands::MeasuredLaw;

void bind_references(py::module_& module) {
  ResultClass<Reference>(module, "Reference", "A source that docstrings, laws, minerals and sands cite.")
      .show("key", "As it is cited.", &Reference::key)
      .show("text", "Authors, year, title, place, volume and pages.", &Reference::text)
      .show("link", "Its address, or an empty text.", &Reference::link)
      .show("remark", "What of it was not checked, and why its number can be used; or an empty text.",
            &Reference::remark);
  define_table(module, "references", references(),
               {"The sources by the keys with which they are cited.", "dict of Reference\n    By their keys.",
                "", "", "references", "core/references.hpp"});
}

void bind_known_sands(py::module_& module) {
  ResultClass<KnownSand>(module, "KnownSand",
                         "A sand often used in laboratories, with its published properties.")
      .show("key", "Its name on a command line.", &KnownSand::key)
      .show("name", "Its full name.", &KnownSand::name)
      .show("source", "Keys of references().", &KnownSand::source)
      .show("mineral", "Key of its mineral, see minerals().", &KnownSand::mineral)
      .show("d50", "[m]; None if not published.", &KnownSand::d50)
      .show("uniformity", "C_u = d60/d10 [1], or None.", &KnownSand::uniformity)
      .show("least_void_ratio", "e_min [1], or None.", &KnownSand::least_void_ratio)
      .show("largest_void_ratio", "e_max [1], or None.", &KnownSand::largest_void_ratio);
  define_table(module, "known_sands", sands::known_sands(),
               {"Sands by name, for the argument sand of packing_answer() and infer().",
                "dict of KnownSand\n    By their keys.", "",
                "Batches of one name differ. [CubrinovskiIshihara2002] [YangSze2011] [CareyStoneKutter2020] "
                "[Azeiteiro2017] [Fioravante2015] [Arulmoli1992] [Tsomokos2010] [Lo2021]",
                "sands::known_sands", "sands/known_sands.hpp"});
  define(module, "void_ratio_of_relative_density",
         {of_input(estimate::Input::relative_density), of_input(estimate::Input::least_void_ratio),
          of_input(estimate::Input::largest_void_ratio)},
         {"The void ratio of a relative density, e_max - D_r (e_max - e_min).",
          "float or ndarray\n    e [1], of the broadcast shape.", "For the first number out of range.", "",
          "sands::void_ratio_of_relative_density", "sands/known_sands.hpp"},
         [](const Arguments& a) {
           return numbers_of_rows(
               a, [](const double* x) { return sands::void_ratio_of_relative_density(x[0], x[1], x[2]); });
         });
}

void bind_measured_laws(py::module_& module) {
  ResultClass<MeasuredLaw>(module, "MeasuredLaw",
                           "A published law of the small-strain shear modulus of sands.")
      .show("key", "Its name on a command line.", &MeasuredLaw::key)
      .show("sand", "The tested material.", &MeasuredLaw::sand)
      .show("source", "Key of references().", &MeasuredLaw::source)
      .show("formula", "In kPa, as in its source.", &MeasuredLaw::formula)
      .show("bias", "Law over measured, geometric mean over 38 clean sands [1].",
            [](const MeasuredLaw& l) { return l.record.bias; })
      .show("rms_log10", "Root mean square of log10 of law over measured, for the same sands [1].",
            [](const MeasuredLaw& l) { return l.record.rms_log10; });
  define_table(
      module, "measured_laws", sands::measured_laws(),
      {"Published laws of the small-strain shear modulus of sands, in the order of their years.",
       "dict of MeasuredLaw\n    By their keys.", "",
       "[HardinRichart1963] [Kokusho1980] [Jamiolkowski1991] [Menq2003] [WichtmannTriantafyllidis2009] "
       "[OztoprakBolton2013] [WangStokoe2022]",
       "sands::measured_laws", "sands/known_sands.hpp"});
  define(module, "sand_shear_modulus",
         {required("law", "str", "A key of measured_laws()."), of_input(estimate::Input::void_ratio),
          of_input(estimate::Input::pressure).called("mean_stress"),
          column("uniformity", "C_u = d60/d10 >= 1 [1]; used by four laws.")
              .or_number(sands::SandState{}.uniformity),
          column("d50", "> 0 [m]; used by two laws.").or_number(sands::SandState{}.d50), strict_keyword()},
         {"Small-strain shear modulus of a sand by a published law.",
          "IsotropicModuli\n    Its notes report numbers outside of the tests of the law. The bulk modulus "
          "is NaN: the laws have none.",
          "For another law, a number out of range, or a void ratio beyond the law's zero.",
          "Under isotropic stress, clean sands. Sources: measured_laws().", "sands::shear_modulus",
          "sands/known_sands.hpp"},
         [](const Arguments& a) {
           const MeasuredLaw& law = sands::measured_law(a.text(0));
           return rows_of(a, ModuliRow{}, [&law](const double* x, Notes& notes) {
             const sands::SandModulus found = sands::shear_modulus(
                 law, {.void_ratio = x[0], .mean_stress = x[1], .uniformity = x[2], .d50 = x[3]});
             notes.add(found.validity);
             return ModuliRow{.shear_modulus = found.shear_modulus};
           });
         });
}

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
                 "Effective stresses along the directions of propagation and of polarisation, > 0 [Pa]."),
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
             std::vector{required("atmospheric_pressure", "float",
                                  "Reference pressure p_a > 0 of C [Pa]; it has no default."),
                         function_keyword(),
                         with_default("weights", "'relative'", "{\"relative\", \"absolute\"}",
                                      "Residuals of ln G, or of G."),
                         with_default("sum_only", "False", "bool",
                                      "Fit only C and s: for paths of one stress ratio, which do not "
                                      "determine m and n separately.")},
         {"Hardin's equation fitted to measured moduli: C, m, n with their covariance.", "Fit",
          "For an invalid row, too few rows, or stresses that do not determine m and n separately.",
          "[HardinRichart1963] [Chung2014]", "hardin::fit", "hardin/fit.hpp",
          "NotConverged\n    If the iteration does not converge.\n"},
         &fit);
}

} // namespace

void bind_sands(py::module_& module) {
  bind_references(module);
  bind_known_sands(module);
  bind_measured_laws(module);
}

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
