// SPDX-License-Identifier: GPL-3.0-or-later
#include "fit.hpp"

#include <filesystem>
#include <memory>

#include <CLI/CLI.hpp>
#include <granum/core/error.hpp>
#include <granum/io/output_file.hpp>

#include "cli/frame/help.hpp"

namespace granum::cli {

namespace {

void require_free(const FitQuestion& question) {
  const std::filesystem::path picture = question.picture;
  if (!picture.empty() && picture.extension() != ".svg")
    throw InvalidArgument("--picture = '" + question.picture + "' must end in .svg");
  if (!picture.empty() && !question.output.force && io::is_taken(picture))
    throw FileError(question.picture, 0, "exists already and is kept; --force replaces it");
}

/// The fit, or what to do where m and n cannot be told apart.
hardin::FitReport fitted(const FitQuestion& question, const std::vector<hardin::MeasuredModulus>& rows,
                         const hardin::FitOptions& options) {
  if (question.sum_only)
    return hardin::fit_exponent_sum(rows, options);
  try {
    return hardin::fit(rows, options);
  } catch (const InvalidArgument& error) {
    if (std::string_view(error.what()).find("cannot be told apart") == std::string_view::npos)
      throw;
    throw InvalidArgument(std::string(error.what()) + ". --sum-only fits s");
  }
}

ExitCode run(FitQuestion question) {
  require_free(question);
  const auto rows = read_rows(question);
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
                   question.output.force ? io::Existing::replace : io::Existing::keep);
  return code;
}

void add_column_options(CLI::App& command, FitQuestion& question) {
  command.add_option("--modulus-column", question.modulus_column,
                     "Column of the modulus; by default G, G_max, G_0, G_vh, ..., the first there is");
  command.add_option(
      "--stress-i-column", question.stress_i_column,
      "Column of sigma_i; by default sigma_v, or as the modulus says: sigma_h for G_hv; where there "
      "is one mean stress alone, p");
  command.add_option("--stress-j-column", question.stress_j_column,
                     "Column of sigma_j; by default sigma_h, or as the modulus says: sigma_v for G_hv");
  command.add_option("--void-ratio-column", question.void_ratio_column,
                     "Column of the void ratio; by default e or void_ratio");
  in_group(command, "Columns",
           {"--modulus-column", "--stress-i-column", "--stress-j-column", "--void-ratio-column"});
}

void add_fit_law_options(CLI::App& command, FitQuestion& question) {
  command.add_flag("--sum-only", question.sum_only,
                   "Fit C and s = m + n only, for paths of one stress ratio");
  std::vector<std::string> functions;
  for (const hardin::VoidRatioFunction function : hardin::all_void_ratio_functions())
    functions.emplace_back(hardin::name(function));
  command
      .add_option_function<std::string>(
          "--void-ratio-function",
          [&question](const std::string& text) {
            question.void_ratio_function = text;
            question.void_ratio_function_given = true;
          },
          "f(e)")
      ->transform(one_of(functions))
      ->default_str(question.void_ratio_function);
  add_quantity(command, "--atmospheric-pressure", question.atmospheric_pressure, Dimension::pressure,
               "p_a, for which C holds");
  command.add_option("--weights", question.weights, "Equal errors of ln G (relative) or of G (absolute)")
      ->transform(one_of({"relative", "absolute"}))
      ->capture_default_str();
  in_group(command, "Law", {"--sum-only", "--void-ratio-function", "--atmospheric-pressure", "--weights"});
}

} // namespace

Command add_fit(CLI::App& program) {
  auto question = std::make_shared<FitQuestion>();
  CLI::App* command =
      program.add_subcommand("fit", "Fit G = C p_a f(e) (sigma_i/p_a)^m (sigma_j/p_a)^n to a CSV file");
  command
      ->add_option("file", question->file,
                   "Table with headings such as G_MPa,sigma_v_kPa,sigma_h_kPa,e or p (kPa),G (MPa),e")
      ->required()
      ->type_name("data.csv");
  add_column_options(*command, *question);
  add_fit_law_options(*command, *question);
  add_output_options(*command, question->output);
  add_picture(*command, question->picture,
              "Draw data and law, with the slopes 1/(1+alpha) of cones and spheres");
  command->footer("Examples:\n"
                  "  granum fit moduli.csv --picture moduli.svg\n"
                  "  granum fit isotropic.csv --sum-only");
  return {command, [question] { return run(*question); }};
}

} // namespace granum::cli
