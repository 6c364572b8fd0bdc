// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_options.hpp"

#include <fmt/core.h>

#include <granum/io/output_file.hpp>

#include "cli/frame/frame.hpp"
#include "cli/frame/help.hpp"
#include "cli/frame/messages.hpp"
#include "scene_file.hpp"
#include "studies/plan/plan.hpp"

namespace granum::cli {

void add_study_options(Command& command, StudyOptions& options, studies::SceneCommand of) {
  Value settings = texts(options.settings, "KEY=VALUE");
  settings.joins_units = true;
  command.add("Scene",
              {{.name = "--scene",
                .value = path(options.scene_file),
                .meaning = "TOML file; by default the six specimens of Chung et al. 2014 (the paper)",
                .synonyms = {{"config c"}}},
               {.name = "--set",
                .value = std::move(settings),
                .meaning = "Override one key, may be repeated: --set grain.radius=0.4mm"},
               {.name = "--grains",
                .value = count(options.grains),
                .meaning = "Grains of a specimen",
                .synonyms = {{"particles ngrains numberofgrains"}}},
               {.name = "--seeds",
                .value = count(options.seeds),
                .meaning = "Specimens of each contact shape and density"},
               {.name = "--threads",
                .value = count(options.threads),
                .meaning = "Specimens computed at the same time; the results do not depend on it",
                .synonyms = {{"j jobs nthreads cores"}}}});
  command.notes = key_help(of);
}

void ResultOptions::print(const std::string& report, const nlohmann::ordered_json& manifest) const {
  deliver({.json = json, .strict = false, .force = false, .out = {}}, within_width(report), manifest, {});
}

void add_result_options(Command& command, ResultOptions& options, const std::string& out_help,
                        const std::string& json_help, const std::string& replaced) {
  add_output_place(command, options.out, options.force, "DIR", out_help, replaced);
  command.row("--force").needs.clear(); // --force is also allowed with the default folder
  command.add(output_group, {{.name = "--json", .value = flag(options.json), .meaning = json_help},
                             {.name = "--quiet",
                              .value = flag(options.quiet),
                              .meaning = "No progress line on a terminal",
                              .synonyms = {{"verbose silent quiet"}}}});
}

void add_strict_scene(Command& command, bool& strict) {
  command.add(output_group,
              {{.name = "--strict",
                .value = flag(strict),
                .meaning = "Stop before the run (exit code 4) if a key of the scene is probably a mistake"}});
}

void say_cost_of_sizes(const studies::Scene& scene) {
  if (const std::string cost = studies::cost_of_sizes(scene); !cost.empty())
    say("note", cost);
}

nlohmann::ordered_json with_cost_of_sizes(nlohmann::ordered_json json, const studies::Scene& scene) {
  if (const std::string cost = studies::cost_of_sizes(scene); !cost.empty())
    json["notes"].push_back(cost);
  return json;
}

bool refuses(const Validity& slips, bool strict) {
  for (const std::string& slip : slips.notes)
    say(strict ? "error" : "warning", slip);
  return strict && !slips.ok();
}

studies::Scene resolve(const StudyOptions& options, studies::SceneCommand command,
                       const studies::Scene& base) {
  SceneInput input(command, base);
  if (!options.scene_file.empty())
    input.read_file(options.scene_file);
  for (const std::string& setting : options.settings)
    input.set(setting);
  studies::StudySection& study = input.scene().study;
  study.grains = options.grains.value_or(study.grains);
  study.seeds = options.seeds.value_or(study.seeds);
  study.threads = options.threads.value_or(study.threads);
  return input.finished();
}

void add_strict(Command& command, bool& strict) {
  command.add(output_group,
              {{.name = "--strict",
                .value = flag(strict),
                .meaning = "Fail (exit code 1) if a result differs from the paper's by more than its goal; "
                           "stop before the run (exit code 4) "
                           "if a key of the scene is probably a mistake"}});
}

ExitCode judged(const std::vector<studies::Verdict>& verdicts, bool strict) {
  ExitCode code = ExitCode::ok;
  const auto fall_short = [&code](std::string_view kind, const studies::Verdict& verdict) {
    say("error", fmt::format("{}: {}: {}", kind, verdict.claim, verdict.measured));
    code = ExitCode::fell_short;
  };
  for (const studies::Verdict& verdict : studies::failed_checks(verdicts))
    fall_short("a check failed", verdict);
  if (strict)
    for (const studies::Verdict& verdict : studies::differing_findings(verdicts))
      fall_short("differs from the paper", verdict);
  return code;
}

void write_panels(const std::filesystem::path& folder, const std::vector<studies::Panel>& panels) {
  prepare_folder(folder, {}, true);
  for (const studies::Panel& panel : panels)
    for (const auto& [ending, text] :
         {std::pair{".csv", studies::panel_csv(panel)}, {".svg", plot::svg(panel.chart)}})
      io::write_file(folder / (panel.stem + ending), text, io::Existing::replace);
}

} // namespace granum::cli
