// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <granum/core/error.hpp>
#include <granum/hardin/fit.hpp>
#include <granum/io/csv/table.hpp>

#include "cli/frame/frame.hpp"

namespace granum::cli {

namespace {

using nlohmann::ordered_json;

struct Options {
  std::string file;
  std::string modulus_column = "G";
  std::string stress_i_column; ///< empty: by the name of the modulus
  std::string stress_j_column;
  std::string void_ratio_column = "e";
  std::string void_ratio_function = "hardin-richart-round";
  std::string weights = "relative";
  double atmospheric_pressure = 100e3;
  bool sum_only = false;
  OutputOptions output;
};

/// G_hv, G_vh and G_hh name their directions i and j; any other modulus is taken as vh.
void fill_in_stress_columns(Options& options) {
  const std::string& name = options.modulus_column;
  const std::size_t end = name.size();
  const bool named =
      end > 3 && name[end - 3] == '_' && name.find_first_not_of("hv", end - 2) == std::string::npos;
  const std::string directions = named ? name.substr(end - 2) : "vh";
  if (options.stress_i_column.empty())
    options.stress_i_column = std::string("sigma_") + directions[0];
  if (options.stress_j_column.empty())
    options.stress_j_column = std::string("sigma_") + directions[1];
}

std::vector<hardin::MeasuredModulus> read_rows(const Options& options, hardin::VoidRatioFunction function) {
  const io::CsvTable table = io::read_csv(options.file);
  const auto modulus = table.numbers(options.modulus_column, Dimension::pressure);
  const auto stress_i = table.numbers(options.stress_i_column, Dimension::pressure);
  const auto stress_j = table.numbers(options.stress_j_column, Dimension::pressure);
  std::vector<double> void_ratio(table.row_count(), 1.0); // any value does where f(e) = 1
  if (function != hardin::VoidRatioFunction::none || table.has(options.void_ratio_column))
    void_ratio = table.numbers(options.void_ratio_column, Dimension::dimensionless);
  std::vector<hardin::MeasuredModulus> rows;
  for (std::size_t k = 0; k < table.row_count(); ++k) {
    rows.push_back({modulus[k], {stress_i[k], stress_j[k], void_ratio[k]}});
    try {
      hardin::require_valid(rows.back(), function);
    } catch (const InvalidArgument& error) {
      throw FileError(options.file, table.line(k),
                      fmt::format("{} (stress_i is {}, stress_j is {})", error.what(),
                                  options.stress_i_column, options.stress_j_column));
    }
  }
  return rows;
}

ordered_json json_of(const Options& options, const hardin::FitReport& report) {
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

std::string table_of(const Options& options, const hardin::FitReport& report) {
  const hardin::Fit& fit = report.fit();
  const std::string& i = options.stress_i_column;
  const std::string& j = options.stress_j_column;
  std::string text;
  const auto line = [&text](const char* symbol, const Measured& e, int digits, const std::string& meaning) {
    text += fmt::format("  {:<9} {:>10.{}f}  +- {:<10.2g} {}\n", symbol, e.value, digits, e.standard_error,
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
  text += fmt::format("  {:<9} {:>10}  {}\n", "", "value", "+- standard error");
  const double c_digits = 3 - std::floor(std::log10(fit.coefficient.value));
  line("C", fit.coefficient, static_cast<int>(std::clamp(c_digits, 0.0, 12.0)),
       "C p_a = " + pretty(fit.coefficient.value * options.atmospheric_pressure, Dimension::pressure));
  if (separate) {
    line("m", *fit.exponent_i, 4, "exponent of " + i);
    line("n", *fit.exponent_j, 4, "exponent of " + j);
  }
  line(separate ? "s = m + n" : "s", fit.exponent_sum, 4, "exponent of mean stress");
  if (separate)
    text +=
        fmt::format("\n  correlation of m and n {:.3f}",
                    fit.covariance[1][2] / std::sqrt(fit.covariance[1][1]) / std::sqrt(fit.covariance[2][2]));
  text += fmt::format("\n  R^2 {}; rms residual {:.2g} % of G; degrees of freedom {}; iterations {}\n",
                      fit.r_squared ? fmt::format("{:.6f}", *fit.r_squared) : "undefined (all moduli equal)",
                      100 * fit.rms_relative_residual, fit.degrees_of_freedom, report.iterations());
  return text;
}

ExitCode run(Options options) {
  fill_in_stress_columns(options);
  const hardin::VoidRatioFunction function = hardin::void_ratio_function(options.void_ratio_function);
  const auto rows = read_rows(options, function);
  const hardin::FitOptions fit_options{.atmospheric_pressure = options.atmospheric_pressure,
                                       .void_ratio_function = function,
                                       .weights = options.weights == "absolute" ? hardin::Weights::absolute
                                                                                : hardin::Weights::relative};
  const auto report =
      options.sum_only ? hardin::fit_exponent_sum(rows, fit_options) : hardin::fit(rows, fit_options);
  return deliver(options.output, table_of(options, report), json_of(options, report), report.fit().validity);
}

} // namespace

Command add_fit(CLI::App& program) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("fit", "Fit G = C p_a f(e) (sigma_i/p_a)^m (sigma_j/p_a)^n to a CSV file");
  command->add_option("file", options->file, "Table with headings such as G_MPa,sigma_v_kPa,sigma_h_kPa,e")
      ->required()
      ->type_name("data.csv");
  command->add_option("--modulus-column", options->modulus_column, "Column of the modulus, without its unit")
      ->capture_default_str();
  command->add_option("--stress-i-column", options->stress_i_column,
                      "Column of sigma_i; by default sigma_v, or as the modulus says: sigma_h for G_hv");
  command->add_option("--stress-j-column", options->stress_j_column,
                      "Column of sigma_j; by default sigma_h, or as the modulus says: sigma_v for G_hv");
  command->add_option("--void-ratio-column", options->void_ratio_column, "Column of the void ratio")
      ->capture_default_str();
  std::vector<std::string> functions;
  for (const hardin::VoidRatioFunction function : hardin::all_void_ratio_functions())
    functions.emplace_back(hardin::name(function));
  command->add_option("--void-ratio-function", options->void_ratio_function, "f(e)")
      ->check(CLI::IsMember(functions))
      ->capture_default_str();
  add_quantity(*command, "--atmospheric-pressure", options->atmospheric_pressure, Dimension::pressure,
               "p_a, for which C holds");
  command->add_flag("--sum-only", options->sum_only,
                    "Fit C and s = m + n only, for paths of one stress ratio");
  command->add_option("--weights", options->weights, "Equal errors of ln G (relative) or of G (absolute)")
      ->check(CLI::IsMember({"relative", "absolute"}))
      ->capture_default_str();
  add_output_options(*command, options->output);
  return {command, [options] { return run(*options); }};
}

} // namespace granum::cli
