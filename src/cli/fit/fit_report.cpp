// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "fit.hpp"

namespace granum::cli {

using nlohmann::ordered_json;

namespace {

/// alpha of a profile A r^alpha of contacts: as many contacts of it at every stress make s = 1/(1+alpha).
constexpr std::pair<const char*, double> contact_shapes[] = {{"cone", 1.0}, {"sphere", 2.0}};

/// The alpha that s would have with contacts of one number; nothing if no contact has it.
std::optional<double> alpha_of(const hardin::Fit& fit) {
  const double s = fit.exponent_sum.value;
  return s > 0 && s <= 0.5 ? std::optional(1 / s - 1) : std::nullopt;
}

/// 1/(1+alpha) beside s.
std::string contacts_text(const hardin::Fit& fit) {
  std::string text;
  for (const auto& [name, alpha] : contact_shapes)
    text += fmt::format("  {:<11} {:>10.4f}  {:<13} contacts of a {}, as many at every stress\n",
                        "1/(1+alpha)", 1 / (1 + alpha), "", name);
  if (const auto alpha = alpha_of(fit))
    return text +
           fmt::format("  {:<11} {:>10.2f}  {:<13} of such contacts with this s\n", "alpha", *alpha, "");
  const bool more = fit.exponent_sum.value > 0.5;
  return text +
         (more ? "  s above 0.5: contacts form as the stress grows, or f(e) leaves a part of it to s\n" : "");
}

} // namespace

ordered_json fit_json(const FitQuestion& options, const hardin::FitReport& report) {
  const hardin::Fit& fit = report.fit();
  const auto value = [](const auto& estimate) {
    return estimate ? ordered_json(estimate->value) : ordered_json();
  };
  const auto error = [](const auto& estimate) {
    return estimate ? ordered_json(estimate->standard_error) : ordered_json();
  };
  ordered_json json = json_head("fit");
  json["inputs"] = {{"file", options.file},
                    {"rows", fit.residuals.size()},
                    {"modulus_column", options.modulus_column},
                    {"stress_i_column", options.stress_i_column},
                    {"stress_j_column", options.stress_j_column},
                    {"void_ratio_column", options.void_ratio_column},
                    {"void_ratio_function", options.void_ratio_function},
                    {"atmospheric_pressure", options.atmospheric_pressure},
                    {"weights", options.weights},
                    {"sum_only", options.sum_only}};
  json["C"] = fit.coefficient.value;
  json["m"] = value(fit.exponent_i);
  json["n"] = value(fit.exponent_j);
  json["s"] = fit.exponent_sum.value;
  json["alpha"] = alpha_of(fit) ? ordered_json(*alpha_of(fit)) : ordered_json();
  for (const auto& [name, alpha] : contact_shapes)
    json["one_over_one_plus_alpha"][name] = 1 / (1 + alpha);
  json["standard_errors"] = {{"C", fit.coefficient.standard_error},
                             {"m", error(fit.exponent_i)},
                             {"n", error(fit.exponent_j)},
                             {"s", fit.exponent_sum.standard_error}};
  json["covariance"] = {{"parameters", fit.parameters}, {"matrix", fit.covariance}};
  json["R2"] = fit.r_squared ? ordered_json(*fit.r_squared) : ordered_json();
  json["rms_relative_residual"] = fit.rms_relative_residual;
  json["residuals"] = fit.residuals;
  json["degrees_of_freedom"] = fit.degrees_of_freedom;
  json["iterations"] = report.iterations();
  json["notes"] = fit.validity.notes;
  return json;
}

std::string fit_table(const FitQuestion& options, const hardin::FitReport& report) {
  const hardin::Fit& fit = report.fit();
  const std::string& i = options.stress_i_column;
  const std::string& j = options.stress_j_column;
  std::string text;
  const auto line = [&text](const char* symbol, const Measured& e, int digits, const std::string& meaning) {
    text += fmt::format("  {:<11} {:>10.{}f}  +- {:<10.2g} {}\n", symbol, e.value, digits, e.standard_error,
                        meaning);
  };
  const bool separate = fit.exponent_i.has_value();
  const std::string stresses = separate ? fmt::format("({}/p_a)^m ({}/p_a)^n", i, j)
                               : i == j ? fmt::format("({}/p_a)^s", i)
                                        : fmt::format("(sqrt({} {})/p_a)^s", i, j);
  text += fmt::format("{} = C p_a f(e) {}\n", options.modulus_column, stresses);
  text += fmt::format("{} rows of {}; p_a = {}, f(e) {}, {} residuals\n\n", fit.residuals.size(),
                      options.file, pretty(options.atmospheric_pressure, Dimension::pressure),
                      options.void_ratio_function, options.weights);
  text += fmt::format("  {:<11} {:>10}  {}\n", "", "value", "+- standard error");
  const double c_digits = 3 - std::floor(std::log10(fit.coefficient.value));
  line("C", fit.coefficient, static_cast<int>(std::clamp(c_digits, 0.0, 12.0)),
       "C p_a = " + pretty(fit.coefficient.value * options.atmospheric_pressure, Dimension::pressure));
  if (separate) {
    line("m", *fit.exponent_i, 4, "exponent of " + i);
    line("n", *fit.exponent_j, 4, "exponent of " + j);
  }
  line(separate ? "s = m + n" : "s", fit.exponent_sum, 4, "exponent of mean stress");
  text += contacts_text(fit);
  if (separate)
    text +=
        fmt::format("\n  correlation of m and n {:.3f}",
                    fit.covariance[1][2] / std::sqrt(fit.covariance[1][1]) / std::sqrt(fit.covariance[2][2]));
  text += fmt::format("\n  R^2 {}; rms residual {:.2g} % of G; degrees of freedom {}; iterations {}\n",
                      fit.r_squared ? fmt::format("{:.6f}", *fit.r_squared) : "undefined (all moduli equal)",
                      100 * fit.rms_relative_residual, fit.degrees_of_freedom, report.iterations());
  return text;
}

plot::Chart fit_chart(const FitQuestion& question, const hardin::Fit& fit,
                      const std::vector<hardin::MeasuredModulus>& rows) {
  const hardin::VoidRatioFunction function = hardin::void_ratio_function(question.void_ratio_function);
  const double s = fit.exponent_sum.value, p_a = question.atmospheric_pressure;
  const double m = fit.equation.exponent_i, n = fit.equation.exponent_j;
  const std::string &i = question.stress_i_column, &j = question.stress_j_column;
  const bool separate = fit.exponent_i.has_value() && std::abs(s) > 1e-6;
  plot::Series data{.name = "measured",
                    .mark = plot::Mark::marker,
                    .x = {},
                    .y = {},
                    .style = 1,
                    .colour = plot::Colour::measured};
  for (const hardin::MeasuredModulus& row : rows) {
    const double share = separate ? m / s : 0.5;
    const double log_x = share * std::log(row.state.stress_i) + (1 - share) * std::log(row.state.stress_j);
    data.x.push_back(std::exp(log_x));
    const bool by_void_ratio = function != hardin::VoidRatioFunction::none;
    data.y.push_back(row.shear_modulus /
                     (by_void_ratio ? hardin::void_ratio_value(function, row.state.void_ratio) : 1));
  }
  const double least = *std::min_element(data.x.begin(), data.x.end());
  const double most = *std::max_element(data.x.begin(), data.x.end());
  const double middle = std::sqrt(least * most);
  const auto line = [&](const std::string& name, double exponent, std::size_t style, plot::Tone tone) {
    const auto at = [&](double x) {
      return fit.coefficient.value * p_a * std::pow(middle / p_a, s) * std::pow(x / middle, exponent);
    };
    return plot::Series{.name = name,
                        .mark = plot::Mark::line,
                        .x = {least, most},
                        .y = {at(least), at(most)},
                        .style = style,
                        .tone = tone,
                        .colour = plot::Colour::closed_form};
  };
  plot::Chart chart{
      .title = fmt::format("{} of {}", question.modulus_column, question.file),
      .x = {.title = i == j     ? i + " [kPa]"
                     : separate ? fmt::format("({}^{:.3f} {}^{:.3f})^(1/s) [kPa]", i, m, j, n)
                                : fmt::format("sqrt({} {}) [kPa]", i, j),
            .scale = plot::Scale::logarithmic,
            .unit = 1e3},
      .y = {.title = question.modulus_column + "/f(e) [MPa]", .scale = plot::Scale::logarithmic, .unit = 1e6},
      .series = {data, line(fmt::format("law, s = {:.3f} +- {:.2g}", s, fit.exponent_sum.standard_error), s,
                            0, plot::Tone::full)}};
  for (const auto& [name, alpha] : contact_shapes)
    chart.series.push_back(line(fmt::format("1/(1+alpha) = {:.3f}, {}", 1 / (1 + alpha), name),
                                1 / (1 + alpha), 2, plot::Tone::grey));
  return chart;
}

} // namespace granum::cli
