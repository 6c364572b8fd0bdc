// SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>
#include <filesystem>
#include <memory>

#include <fmt/core.h>
#include <granum/core/error.hpp>

#include "cli/frame/frame.hpp"
#include "cli/frame/help.hpp"
#include "cli/frame/long_work.hpp"
#include "cli/frame/messages.hpp"
#include "cli/options/likely_mistakes.hpp"
#include "cli/options/study_options.hpp"
#include "verify_document.hpp"

namespace granum::cli {

namespace {

namespace fs = std::filesystem;

struct VerifyOptions {
  StudyOptions study;
  std::string report;
  bool strict = false;
  ResultOptions results;
};

ExitCode report_again(const VerifyOptions& options) {
  rewrite_page(options.report);
  options.results.print(fmt::format("report.html and figures in {}\n", options.report),
                        {{"report", (fs::path(options.report) / "report.html").string()}});
  return ExitCode::ok;
}

ExitCode run(const VerifyOptions& options) {
  if (!options.report.empty())
    return report_again(options);
  const studies::Scene scene = resolve(options.study, studies::SceneCommand::verify);
  const Validity slips = likely_mistakes(scene);
  if (refuses(slips, options.strict))
    return ExitCode::not_converged;
  say_cost_of_sizes(scene);
  const std::atomic<bool>& stop = listen_for_stop();
  const ResultOptions& results = options.results;
  const bool writes = results.writes_files();
  const fs::path folder =
      writes ? results_folder(results.out, "verify", study_file_names(), results.force) : fs::path();
  const auto start = std::chrono::steady_clock::now();
  std::vector<studies::SpecimenResult> specimens;
  {
    ProgressLine line(results.quiet);
    specimens = studies::run_study(
        scene, {.report = [&line](const studies::Progress& p) { line.show(p); }, .stop = &stop});
  }
  const double seconds = seconds_since(start);
  const bool stopped = stop;
  const std::vector<studies::Verdict> verdicts = studies::verdicts(scene, specimens);
  const StudyDocument study =
      study_document(scene, results_of(scene, specimens, verdicts, seconds, options.study, slips));
  const nlohmann::ordered_json manifest = with_warnings(json(study.document), slips);
  if (writes)
    write_results(folder, scene, study, manifest, results.existing());
  const std::string where =
      writes ? "report.html, pictures, CSV and manifest in " + folder.string() + "\n" : "";
  results.print(screen(study.document, false) + where, manifest);
  if (stopped && !complete(specimens)) {
    say("", "stopped; claims that need the remaining specimens were not checked");
    return exit_code_of_stop();
  }
  const ExitCode code = judged(verdicts, options.strict); // reports specimens that ended early too
  return complete(specimens) ? code : ExitCode::not_converged;
}

} // namespace

Command make_verify() {
  auto options = std::make_shared<VerifyOptions>();
  Command command{
      .name = "verify",
      .meaning = "Compare closed forms, contact networks and DEM, dense and loose: the exponent s of G ~ p^s",
      .run = [options] { return run(*options); }};
  add_study_options(command, options->study, studies::SceneCommand::verify);
  command.add(
      "Run",
      {{.name = "--report",
        .value = path(options->report, "DIR"),
        .meaning = "Write report.html and its figures again from the finished run in this folder",
        .excludes = {{"--scene --set --grains --seeds --threads --out",
                      "--report uses the earlier run; no scene and no other folder may be given with it"}}}});
  add_strict(command, options->strict);
  add_result_options(command, options->results,
                     "Folder for report, CSV and manifest; by default a new granum-verify-N");
  return command;
}

} // namespace granum::cli
