// SPDX-License-Identifier: GPL-3.0-or-later
#include "reproduce_output.hpp"

#include "studies/reproduce/experiment_tables.hpp"
#include "studies/reproduce/figures/experiment_figures.hpp"
#include "studies/verify/tables.hpp"
#include <fmt/core.h>
#include <granum/io/output_file.hpp>

#include "cli/frame/frame.hpp"
#include "cli/frame/json_members.hpp"
#include "cli/options/panel_files.hpp"
#include "cli/options/scene_file.hpp"

namespace granum::cli {

namespace {

using nlohmann::ordered_json;
namespace fs = std::filesystem;

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

} // namespace

std::span<const char* const> result_names() { return written_names; }

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
      {"signs", "compression positive; z is vertical; eta = (s_v - s_h)/p'; strains are logarithmic"},
      {"G", "of the contact network of the frozen state, every contact sticking; probes by cyclic shear"}};
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

std::string report_of(const studies::Experiment& experiment, const std::vector<studies::Verdict>& verdicts,
                      const studies::RunTime& time) {
  std::string out = "granum +- standard error, compared with the paper; within: whether the difference is "
                    "within the tolerance, undecided if the standard error exceeds it\n\n";
  out += studies::table_text("Table 2: start of isotropic compression", studies::table_2(experiment)) + "\n";
  out += studies::table_text("Table 4: friction angle at the peak", studies::table_4(experiment)) + "\n";
  out +=
      studies::table_text("Table 5: G = C p_a f(e) (s_i/p_a)^m (s_j/p_a)^n", studies::table_5(experiment)) +
      "\n";
  out += studies::table_text("Further exponents", studies::further_exponents(experiment)) + "\n";
  out += studies::verdicts_table(verdicts);
  return out + fmt::format("\n{} specimens of {} grains, {} frozen states in {:.1f} s on {}\n",
                           experiment.specimens.size(), experiment.scene.study.grains,
                           frozen_states(experiment), time.seconds,
                           threads_text(studies::thread_count(experiment.scene)));
}

} // namespace granum::cli
