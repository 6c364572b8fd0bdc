// SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "studies/reproduce/experiment_html.hpp"
#include "studies/reproduce/experiment_tables.hpp"
#include "studies/reproduce/figures/experiment_figures.hpp"
#include "studies/verify/tables.hpp"
#include <fmt/core.h>
#include <granum/core/error.hpp>
#include <granum/io/output_file.hpp>

#include "cli/frame/frame.hpp"
#include "cli/frame/help.hpp"
#include "cli/frame/json_members.hpp"
#include "cli/frame/long_work.hpp"
#include "cli/frame/messages.hpp"
#include "cli/options/likely_mistakes.hpp"
#include "cli/options/scene_file.hpp"
#include "cli/options/study_options.hpp"

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

constexpr const char* scene_of_run = "scene.toml";
constexpr const char* checkpoints_name = "checkpoints";

/// Files and folders that write_results makes.
constexpr const char* written_names[] = {"states.csv",   "curves.csv",    "loops.csv",   "histograms.csv",
                                         "table2.csv",   "table4.csv",    "table5.csv",  "exponents.csv",
                                         "verdicts.csv", "manifest.json", "report.html", "figures"};

ordered_json table_json(const std::vector<studies::TableRow>& rows) {
  return members_of_all(studies::cell_columns(), studies::cell_rows(rows));
}

/// Numbers and picture of every panel.
void write_figures(const fs::path& folder, const std::vector<studies::Figure>& figures,
                   const std::optional<studies::AssemblyPicture>& assembly) {
  prepare_folder(folder, {}, true);
  const auto write = [&](const std::string& name, const std::string& text) {
    io::write_file(folder / name, text, io::Existing::replace);
  };
  if (assembly)
    write(assembly->stem + ".svg", assembly->svg);
  for (const studies::Figure& figure : figures)
    write_panels(folder, figure.panels);
}

ordered_json run_json(const studies::ExperimentSpecimen& specimen, const studies::PathRun& run) {
  return {{"contact", contact::name(specimen.contact)},
          {"density", studies::name(specimen.density)},
          {"seed", specimen.seed},
          {"path", studies::name(run.path)},
          {"frozen_states", run.points.size()},
          {"steps", run.steps},
          {"peak_eta", run.peak.stress.ratio()},
          {"path_error", run.path_error},
          {"largest_inertial_number", run.largest_inertial_number},
          {"notes", run.notes},
          {"failure", run.failure}};
}

ordered_json manifest_of(const studies::Experiment& experiment, const std::vector<studies::Verdict>& verdicts,
                         const studies::RunTime& time) {
  ordered_json json = json_head("reproduce");
  json["wall_time_s"] = time.seconds;
  json["resumed"] = time.resumed;
  json["complete"] = experiment.complete();
  json["scene"] = json_of(experiment.scene);
  json["threads_used"] = studies::thread_count(experiment.scene);
  json["conventions"] = {
      {"units", "SI, as in the names; friction angles in degrees"},
      {"signs", "compression positive; z is vertical; eta = q/p' = (s_v - s_h)/p', s_v and s_h the vertical "
                "and the horizontal stress; strains are logarithmic"},
      {"G", "of the contact network of the frozen state, without sliding in any contact; probes by cyclic "
            "shear"}};
  json["table_2"] = table_json(studies::table_2(experiment));
  json["table_4"] = table_json(studies::table_4(experiment));
  json["table_5"] = table_json(studies::table_5(experiment));
  json["further_exponents"] = table_json(studies::further_exponents(experiment));
  json["verdicts"] = members_of_all(studies::verdict_columns(), verdicts);
  json["runs"] = ordered_json::array();
  for (const studies::ExperimentSpecimen& specimen : experiment.specimens)
    for (const studies::PathRun& run : specimen.runs)
      json["runs"].push_back(run_json(specimen, run));
  return json;
}

/// Tables, figures, report.html and manifest; replaces those of an earlier run.
/// \throws   FileError
void write_results(const fs::path& folder, const studies::Experiment& experiment,
                   const std::vector<studies::Verdict>& verdicts, const ordered_json& manifest,
                   const studies::RunTime& time) {
  const auto write = [&](const char* name, const std::string& text) {
    io::write_file(folder / name, text, io::Existing::replace);
  };
  write("states.csv", studies::frozen_states_csv(experiment));
  write("curves.csv", studies::curves_csv(experiment));
  write("loops.csv", studies::loops_csv(experiment));
  write("histograms.csv", studies::histograms_csv(experiment));
  write("table2.csv", studies::table_csv(studies::table_2(experiment)));
  write("table4.csv", studies::table_csv(studies::table_4(experiment)));
  write("table5.csv", studies::table_csv(studies::table_5(experiment)));
  write("exponents.csv", studies::table_csv(studies::further_exponents(experiment)));
  write("verdicts.csv", io::csv_text(studies::verdict_columns(), verdicts));
  const std::vector<studies::Figure> figures = studies::experiment_figures(experiment);
  const std::optional<studies::AssemblyPicture> assembly = studies::assembly_picture(experiment);
  const studies::ExperimentReport report =
      studies::experiment_report(experiment, verdicts, figures, assembly, time);
  const fs::path pictures = folder / studies::figures_folder;
  write_figures(pictures, figures, assembly);
  write_panels(pictures, report.panels);
  write("report.html", report.html);
  write("manifest.json", json_text(manifest));
}

/// Tables 2, 4 and 5 with the paper's values, and the verdicts, as text.
std::string report_of(const studies::Experiment& experiment, const std::vector<studies::Verdict>& verdicts,
                      const studies::RunTime& time) {
  std::string out = "granum: result of this run +- its standard error, where it is known; paper:\n"
                    "Chung et al. 2014; within: whether the difference is within the tolerance,\n"
                    "undecided if the standard error exceeds the tolerance\n\n";
  out += studies::table_text("Table 2: start of isotropic compression (C_n: contacts per grain, e: void\n"
                             "ratio)",
                             studies::table_2(experiment)) +
         "\n";
  out += studies::table_text("Table 4: friction angle at the peak of q/p', by stress path",
                             studies::table_4(experiment)) +
         "\n";
  out +=
      studies::table_text("Table 5: G_hv = C p_a f(e) (sigma_h/p_a)^m (sigma_v/p_a)^n, s = m + n, and G_hh\n"
                          "with sigma_h alone; of the contact networks at |q/p'| up to 0.6",
                          studies::table_5(experiment)) +
      "\n";
  out += studies::table_text("Further exponents", studies::further_exponents(experiment)) + "\n";
  out += studies::verdicts_table(verdicts);
  return out + fmt::format("\n{} specimens of {} grains, {} frozen states in {:.1f} s on {}\n",
                           experiment.specimens.size(), experiment.scene.study.grains,
                           frozen_states(experiment), time.seconds,
                           threads_text(studies::thread_count(experiment.scene)));
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

/// State of a run: its scene and its folder, which contains the scene and a folder of checkpoints.
struct Place {
  studies::Scene scene;
  fs::path folder;
};

/// Refuses to replace a folder with an unfinished run, which can be continued.
/// \throws   FileError
void suggest_resume(const ResultOptions& results) {
  const fs::path folder = results.out;
  if (!results.out.empty() && !results.force && io::is_taken(folder / scene_of_run) &&
      io::is_taken(folder / checkpoints_name) && !io::is_taken(folder / "manifest.json"))
    throw FileError(
        results.out, 0,
        fmt::format("contains an unfinished run; continue it with: granum reproduce --resume {}, or "
                    "start again with --force",
                    results.out));
}

studies::Scene new_scene(const ReproduceOptions& options) {
  return resolve(options.study, studies::SceneCommand::reproduce,
                 options.paper ? paper_scene() : studies::Scene{});
}

Place new_place(const ReproduceOptions& options, const studies::Scene& scene) {
  Place place{.scene = scene, .folder = {}};
  std::vector<const char*> names(std::begin(written_names), std::end(written_names));
  names.push_back(scene_of_run);
  names.push_back(checkpoints_name);
  suggest_resume(options.results);
  place.folder = results_folder(options.results.out, "reproduce", names, options.results.force);
  studies::remove_checkpoints(place.folder / checkpoints_name); // present only with --force
  fs::create_directories(place.folder / checkpoints_name);      // before the scene: both together are a run
  io::write_file(place.folder / scene_of_run, studies::toml_of(place.scene), options.results.existing());
  return place;
}

/// Reads a stopped run, or a finished one whose tables and pictures are to be written again. Any other folder
/// may hold files of the same names, which would be lost.
/// \throws   FileError
Place old_place(const ReproduceOptions& options) {
  const StudyOptions& study = options.study;
  const fs::path folder = options.resume;
  Place place{.scene = read_scene((folder / scene_of_run).string(), studies::SceneCommand::reproduce),
              .folder = folder};
  if (!fs::is_directory(folder / checkpoints_name))
    throw FileError((folder / checkpoints_name).string(), 0,
                    "does not exist: --resume needs the folder of an earlier granum reproduce");
  if (study.threads) {
    place.scene.study.threads = *study.threads;
    studies::require_valid(place.scene);
  }
  return place;
}

ExitCode run(const ReproduceOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const std::atomic<bool>& stop = listen_for_stop();
  const bool anew = options.resume.empty();
  const studies::Scene scene = anew ? new_scene(options) : studies::Scene{};
  if (anew && refuses(likely_mistakes(scene), options.strict))
    return ExitCode::not_converged;
  const Place place = anew ? new_place(options, scene) : old_place(options);
  say_cost_of_sizes(place.scene);
  const fs::path checkpoints = place.folder / checkpoints_name;
  studies::Experiment experiment;
  {
    ProgressLine line(options.results.quiet);
    experiment = studies::run_experiment(
        place.scene, {.report = [&line](const studies::Progress& p) { line.show(p); }, .stop = &stop},
        {.folder = checkpoints, .scene_text = identity(place.scene)});
  }
  if (stop && !experiment.complete()) {
    say("", fmt::format("stopped; continue with: granum reproduce --resume {}", place.folder.string()));
    return exit_code_of_stop();
  }
  const std::vector<studies::Verdict> verdicts = studies::experiment_verdicts(experiment);
  const studies::RunTime time{.seconds = seconds_since(start), .resumed = !anew};
  const ordered_json manifest = with_cost_of_sizes(
      with_warnings(manifest_of(experiment, verdicts, time), likely_mistakes(place.scene)), place.scene);
  write_results(place.folder, experiment, verdicts, manifest, time);
  options.results.print(report_of(experiment, verdicts, time) + "report.html, tables and pictures in " +
                            place.folder.string() + "\n",
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
                   "finished "
                   "run, write its tables and pictures again",
        .excludes = {{"--paper --scene --set --grains --seeds --out",
                      "--resume takes its scene and folder from the earlier run; only --threads may be given "
                      "with it"}}}});
  add_strict(command, options->strict);
  add_result_options(command, options->results, "Folder for the results; by default a new granum-reproduce-N",
                     "Print the manifest as one JSON object, SI units", "existing results and checkpoints");
  return command;
}

} // namespace granum::cli
