// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>

#include "studies/verify/findings.hpp"
#include "studies/verify/study.hpp"
#include "studies/verify/tables.hpp"
#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <granum/core/error.hpp>
#include <granum/io/output_file.hpp>

#include "cli/frame/frame.hpp"
#include "cli/frame/json_members.hpp"
#include "cli/frame/progress.hpp"
#include "cli/frame/stop_signal.hpp"
#include "cli/options/scene_file.hpp"
#include "cli/options/study_options.hpp"

namespace granum::cli {

namespace {

using nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;
namespace fs = std::filesystem;

struct Options {
  StudyOptions study;
  ResultOptions results;
};

constexpr const char* file_names[] = {"states.csv", "exponents.csv", "manifest.json"};

ordered_json exponent_json(const std::optional<Measured>& exponent) {
  if (!exponent)
    return nullptr;
  return {{"value", exponent->value}, {"standard_error", exponent->standard_error}};
}

struct Outcome {
  studies::Scene scene;
  std::vector<studies::SpecimenResult> specimens;
  std::vector<studies::ExponentRow> exponents;
  std::vector<studies::Verdict> verdicts;
  double seconds = 0;
  bool stopped = false; ///< on request

  [[nodiscard]] bool complete() const {
    return std::all_of(specimens.begin(), specimens.end(), [](const auto& s) { return s.failure.empty(); });
  }
  [[nodiscard]] bool all_hold() const {
    return std::all_of(verdicts.begin(), verdicts.end(), [](const auto& v) { return v.holds; });
  }
};

ordered_json manifest_of(const Outcome& outcome, const Options& options) {
  ordered_json json = json_head("verify");
  json["wall_time_s"] = outcome.seconds;
  json["complete"] = outcome.complete();
  json["scene_file"] = options.study.scene_file;
  json["settings"] = options.study.settings;
  json["scene"] = json_of(outcome.scene);
  json["threads_used"] = studies::thread_count(outcome.scene);
  json["conventions"] = {
      {"units", "SI, as the names say"},
      {"signs", "compression positive; overlap is the full approach of two centres; z is vertical"},
      {"mass_scaling",
       "translation: none, density times volume; rotational inertia m R^2 instead of 0.4 m R^2"},
      {"time_step", "0.8 of 2/omega with a strict upper bound on omega, chosen by the program"},
      {"damping", "mass-proportional on the motion beyond the affine one, twice the lowest frequency seen"}};
  for (const studies::ExponentRow& row : outcome.exponents)
    json["exponents"].push_back({{"contact", contact::name(row.contact)},
                                 {"density", studies::name(row.density)},
                                 {"contact_law", row.contact_law},
                                 {"closed_form", exponent_json(row.closed_form)},
                                 {"network", exponent_json(row.network)},
                                 {"network_with_void_ratio_function", exponent_json(row.network_void)},
                                 {"probe", exponent_json(row.probe)},
                                 {"paper", row.paper ? ordered_json(*row.paper) : ordered_json()}});
  for (const studies::Verdict& verdict : outcome.verdicts)
    json["verdicts"].push_back(
        {{"claim", verdict.claim}, {"holds", verdict.holds}, {"measured", verdict.measured}});
  for (const studies::SpecimenResult& specimen : outcome.specimens) {
    ordered_json entry = {{"contact", contact::name(specimen.contact)},
                          {"density", studies::name(specimen.density)},
                          {"seed", specimen.seed},
                          {"failure", specimen.failure},
                          {"states", ordered_json::array()}};
    for (const studies::CompressedState& state : specimen.states)
      entry["states"].push_back(members(studies::state_columns(), state));
    json["specimens"].push_back(entry);
  }
  return json;
}

Outcome run_and_judge(const studies::Scene& scene, const std::atomic<bool>& stop, bool quiet) {
  Outcome outcome;
  outcome.scene = scene;
  const Clock::time_point start = Clock::now();
  ProgressLine line(quiet);
  outcome.specimens = studies::run_study(
      scene, {.report = [&line](const studies::Progress& p) { line.show(p); }, .stop = &stop});
  outcome.seconds = seconds_since(start);
  outcome.stopped = stop;
  outcome.exponents = studies::exponents(scene, outcome.specimens);
  outcome.verdicts = studies::verdicts(scene, outcome.specimens);
  return outcome;
}

std::string report_of(const Outcome& outcome) {
  return fmt::format("{}\n{}\n{}\n{} specimens of {} grains in {:.1f} s on {} threads\n",
                     studies::states_table(outcome.specimens), studies::exponents_table(outcome.exponents),
                     studies::verdicts_table(outcome.verdicts), outcome.specimens.size(),
                     outcome.scene.study.grains, outcome.seconds, studies::thread_count(outcome.scene));
}

void write_results(const fs::path& folder, const Outcome& outcome, const Options& options) {
  const io::Existing existing = options.results.existing();
  io::write_file(folder / file_names[0], studies::states_csv(outcome.scene, outcome.specimens), existing);
  io::write_file(folder / file_names[1], studies::exponents_csv(outcome.exponents), existing);
  io::write_file(folder / file_names[2], json_text(manifest_of(outcome, options)), existing);
}

ExitCode run(const Options& options) {
  const studies::Scene scene = resolve(options.study, studies::SceneCommand::verify);
  const std::atomic<bool>& stop = listen_for_stop();
  const ResultOptions& results = options.results;
  const bool writes = results.writes_files();
  const fs::path folder =
      writes ? results_folder(results.out, "verify", file_names, results.force) : fs::path();
  const Outcome outcome = run_and_judge(scene, stop, results.quiet);
  if (writes)
    write_results(folder, outcome, options);
  const std::string where = writes ? "CSV and manifest in " + folder.string() + "\n" : "";
  results.print(report_of(outcome) + where, manifest_of(outcome, options));
  if (!outcome.complete())
    return outcome.stopped ? exit_code_of_stop() : ExitCode::not_converged;
  return outcome.all_hold() ? ExitCode::ok : ExitCode::fell_short;
}

} // namespace

Command add_verify(CLI::App& program) {
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "verify", "Closed form against network and DEM, dense and loose: the exponent s");
  add_study_options(*command, options->study, studies::SceneCommand::verify);
  add_result_options(*command, options->results,
                     "Folder for CSV and manifest; by default a new granum-verify-N");
  return {command, [options] { return run(*options); }};
}

} // namespace granum::cli
