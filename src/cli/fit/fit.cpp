// SPDX-License-Identifier: GPL-3.0-or-later
#include "fit.hpp"

#include <cmath>
#include <memory>

#include <granum/core/error.hpp>
#include <granum/io/output_file.hpp>

#include "cli/frame/help.hpp"

namespace granum::cli {

namespace {

/// The fit, or advice if m and n cannot be separated.
hardin::FitReport fitted(const FitQuestion& question, const std::vector<hardin::MeasuredModulus>& rows,
                         const hardin::FitOptions& options) {
  if (question.sum_only)
    return hardin::fit_exponent_sum(rows, options);
  try {
    return hardin::fit(rows, options);
  } catch (const InvalidArgument& error) {
    if (std::string_view(error.what()).find("cannot be separated") == std::string_view::npos)
      throw;
    throw InvalidArgument(std::string(error.what()) + ". --sum-only fits s");
  }
}

double middle_stress(const std::vector<hardin::MeasuredModulus>& rows) {
  double sum = 0;
  for (const hardin::MeasuredModulus& row : rows)
    sum += std::log(row.state.stress_i) + std::log(row.state.stress_j);
  return std::exp(sum / (2 * static_cast<double>(rows.size())));
}

ExitCode run(FitQuestion question) {
  require_free(question.output, question.picture);
  const auto rows = read_rows(question);
  question.middle_stress = middle_stress(rows);
  const hardin::VoidRatioFunction function = hardin::void_ratio_function(question.void_ratio_function);
  const hardin::FitOptions options{.atmospheric_pressure = question.atmospheric_pressure,
                                   .void_ratio_function = function,
                                   .weights = question.weights == "absolute" ? hardin::Weights::absolute
                                                                             : hardin::Weights::relative};
  const hardin::FitReport report = fitted(question, rows, options);
  Validity validity = question.remarks;
  validity.merge(report.fit().validity);
  const ExitCode code = deliver(question.output, within_width(fit_table(question, report)),
                                fit_json(question, report), validity);
  if (!question.picture.empty())
    io::write_file(question.picture, plot::svg(fit_chart(question, report.fit(), rows)),
                   existing(question.output.force));
  return code;
}

void add_column_options(Command& command, FitQuestion& question) {
  command.add(
      "Columns",
      {{.name = "--modulus-column",
        .value = text(question.modulus_column),
        .meaning = "Column of the modulus; by default the first of G, G_max, G_0, G_vh, ... in the table"},
       {.name = "--stress-i-column",
        .value = text(question.stress_i_column),
        .meaning = "Column of sigma_i, whose exponent is m; by default sigma_h; p in tables with only a mean "
                   "stress"},
       {.name = "--stress-j-column",
        .value = text(question.stress_j_column),
        .meaning = "Column of sigma_j, whose exponent is n; by default sigma_v; sigma_h for a column G_hh"},
       {.name = "--void-ratio-column",
        .value = text(question.void_ratio_column),
        .meaning = "Column of the void ratio; by default e or void_ratio"}});
}

void add_fit_law_options(Command& command, FitQuestion& question) {
  std::vector<std::string> functions;
  for (const hardin::VoidRatioFunction function : hardin::all_void_ratio_functions())
    functions.emplace_back(hardin::name(function));
  Value function = choice(functions, [&question](const std::string& text) {
    question.void_ratio_function = text;
    question.void_ratio_function_given = true;
  });
  function.by_default = question.void_ratio_function;
  command.add("Law",
              {{.name = "--sum-only",
                .value = flag(question.sum_only),
                .meaning = "Fit C and s = m + n only, for data of a single stress ratio"},
               {.name = "--void-ratio-function", .value = std::move(function), .meaning = "f(e)"},
               {.name = "--atmospheric-pressure",
                .value = quantity(question.atmospheric_pressure, Dimension::pressure),
                .meaning = "Reference pressure p_a of the law",
                .synonyms = {{"pa patm pref referencepressure"}}},
               {.name = "--weights",
                .value = choice({"relative", "absolute"}, question.weights),
                .meaning = "Assume the same relative error of G in all rows (residuals of ln G), or the same "
                           "absolute error"}});
}

} // namespace

Command make_fit() {
  auto question = std::make_shared<FitQuestion>();
  Command command{.name = "fit",
                  .meaning =
                      "Fit G = C p_a f(e) (sigma_i/p_a)^m (sigma_j/p_a)^n to a CSV file (e: void ratio, p_a: "
                      "atmospheric pressure)",
                  .notes = "Examples:\n"
                           "  granum fit moduli.csv --picture moduli.svg\n"
                           "  granum fit isotropic.csv --sum-only",
                  .run = [question] { return run(*question); }};
  command.add({.name = "file",
               .value = text(question->file, "data.csv"),
               .meaning = "CSV file with a modulus, two stresses or one mean stress, and e; headings such as "
                          "G_MPa,sigma_v_kPa,sigma_h_kPa,e or p_kPa,G_MPa,e",
               .required = true});
  add_column_options(command, *question);
  add_fit_law_options(command, *question);
  add_output_options(command, question->output);
  add_picture(command, question->picture,
              "Draw data and law, with the slopes 1/(1+alpha) of cones and spheres");
  return command;
}

} // namespace granum::cli
