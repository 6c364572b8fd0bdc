// SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <granum/core/error.hpp>
#include <granum/io/output_file.hpp>

#include "cli/frame/frame.hpp"
#include "cli/frame/help.hpp"
#include "cli/frame/long_work.hpp"
#include "cli/frame/messages.hpp"
#include "cli/options/likely_mistakes.hpp"
#include "cli/options/scene_file.hpp"
#include "cli/options/study_options.hpp"
#include "reproduce_document.hpp"

namespace granum::cli {

namespace {

using nlohmann::ordered_json;
namespace fs = std::filesystem;

struct ReproduceOptions {
  StudyOptions study;
  bool paper = false;
  std::string resume;
  bool strict = false;
  ResultOptions results;
};

constexpr const char* stored_scene = "scene.toml";
constexpr const char* checkpoints_name = "checkpoints";

/// Files and folders of a run.
constexpr const char* written_names[] = {"states.csv",   "curves.csv",    "loops.csv",   "histograms.csv",
                                         "table2.csv",   "table4.csv",    "table5.csv",  "exponents.csv",
                                         "verdicts.csv", "manifest.json", "report.html", figures_name,
                                         stored_scene,   checkpoints_name};

/// Tables, figures, page and manifest; replaces those of an earlier run.
/// \throws   FileError
void write_results(const fs::path& folder, const ExperimentDocument& of, const ordered_json& manifest) {
  const auto write = [&](const std::string& name, const std::string& text) {
    io::write_file(folder / name, text, io::Existing::replace);
  };
  prepare_folder(folder / figures_name, {}, true);
  for (const auto& [name, text] : of.files)
    write(name, text);
  write_panels(folder / figures_name, of.panels);
  write("report.html", page(of.document));
  write("manifest.json", json_text(manifest)); // the last: with it a run is complete
}

/// The paper's own size: 10,000 grains between six rigid walls.
studies::Scene paper_scene() {
  studies::Scene scene;
  scene.study.grains = 10000;
  scene.specimen.walls = true;
  // at 10 kPa loose specimens of this size are hardly at rest
  scene.study.probe_pressures = {30e3, 60e3, 100e3};
  scene.shear.probe_eta_step = 0.6;
  return scene;
}

/// Whether two scenes give the same results: the number of threads is ignored. A stored scene of equal grains
/// may lack grain.sizes.
std::string identity(studies::Scene scene) {
  scene.study.threads = 0;
  std::string text = studies::toml_of(scene);
  const std::string of_equal_grains = "sizes = \"equal\"\n";
  if (const std::size_t at = text.find(of_equal_grains); at != std::string::npos)
    text.erase(at, of_equal_grains.size());
  return text;
}

/// Makes the folder of a new run. One with an unfinished run, which can be continued, is refused.
/// \throws   FileError
fs::path new_folder(const ResultOptions& results, const studies::Scene& scene) {
  const fs::path asked = results.out;
  if (!results.out.empty() && !results.force && io::is_taken(asked / stored_scene) &&
      io::is_taken(asked / checkpoints_name) && !io::is_taken(asked / "manifest.json"))
    throw FileError(
        results.out, 0,
        fmt::format("contains an unfinished run; continue it with: granum reproduce --resume {}, or "
                    "start again with --force",
                    results.out));
  fs::path folder = results_folder(results.out, "reproduce", written_names, results.force);
  studies::remove_checkpoints(folder / checkpoints_name); // present only with --force
  fs::create_directories(folder / checkpoints_name);      // before the scene: both together are a run
  io::write_file(folder / stored_scene, studies::toml_of(scene), results.existing());
  return folder;
}

/// The scene of a stopped run, or of a finished one whose tables and pictures are to be written again. Any
/// other folder may hold files of the same names, which would be lost.
/// \throws   FileError
studies::Scene old_scene(const fs::path& folder, const std::optional<std::size_t>& threads) {
  studies::Scene scene = read_scene((folder / stored_scene).string(), studies::SceneCommand::reproduce);
  if (!fs::is_directory(folder / checkpoints_name))
    throw FileError((folder / checkpoints_name).string(), 0,
                    "does not exist: --resume needs the folder of an earlier granum reproduce");
  scene.study.threads = threads.value_or(scene.study.threads);
  studies::require_valid(scene);
  return scene;
}

ExitCode run(const ReproduceOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const std::atomic<bool>& stop = listen_for_stop();
  const bool anew = options.resume.empty();
  const studies::Scene scene = anew ? resolve(options.study, studies::SceneCommand::reproduce,
                                              options.paper ? paper_scene() : studies::Scene{})
                                    : old_scene(options.resume, options.study.threads);
  const Validity slips = likely_mistakes(scene);
  if (anew && refuses(slips, options.strict))
    return ExitCode::not_converged;
  const fs::path folder = anew ? new_folder(options.results, scene) : fs::path(options.resume);
  say_cost_of_sizes(scene);
  studies::Experiment experiment;
  {
    ProgressLine line(options.results.quiet);
    experiment = studies::run_experiment(
        scene, {.report = [&line](const studies::Progress& p) { line.show(p); }, .stop = &stop},
        {.folder = folder / checkpoints_name, .scene_text = identity(scene)});
  }
  if (stop && !experiment.complete()) {
    say("", fmt::format("stopped; continue with: granum reproduce --resume {}", folder.string()));
    return exit_code_of_stop();
  }
  const std::vector<studies::Verdict> verdicts = studies::experiment_verdicts(experiment);
  const ExperimentDocument found =
      experiment_document(experiment, verdicts, {.seconds = seconds_since(start), .resumed = !anew});
  const ordered_json manifest = with_warnings(json(found.document), slips);
  write_results(folder, found, manifest);
  options.results.print(screen(found.document, false) + "report.html, tables and pictures in " +
                            folder.string() + "\n",
                        manifest);
  const ExitCode code = judged(verdicts, options.strict);
  return experiment.complete() ? code : ExitCode::not_converged;
}

} // namespace

Command make_reproduce() {
  auto options = std::make_shared<ReproduceOptions>();
  Command command{
      .name = "reproduce",
      .meaning = "The experiment of Chung et al. 2014: six specimens, four stress paths, tables and figures",
      .run = [options] { return run(*options); }};
  add_study_options(command, options->study, studies::SceneCommand::reproduce);
  command.add(
      "Run",
      {{.name = "--paper",
        .value = flag(options->paper),
        .meaning = "10,000 grains between six rigid walls, as in the paper; 7 to 11 minutes on two cores",
        .excludes = {{"--scene", "--paper is itself a scene; give one of --paper and --scene"}}},
       {.name = "--resume",
        .value = path(options->resume, "DIR"),
        .meaning = "Continue the run in this folder from its last checkpoints, with identical results; for a "
                   "finished run, write its tables and pictures again",
        .excludes = {{"--paper --scene --set --grains --seeds --out",
                      "--resume takes its scene and folder from the earlier run; only --threads may be given "
                      "with it"}}}});
  add_strict(command, options->strict);
  add_result_options(command, options->results, "Folder for the results; by default a new granum-reproduce-N",
                     "Print the manifest as one JSON object, SI units", "existing results and checkpoints");
  return command;
}

} // namespace granum::cli
