// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_options.hpp"

#include "studies/plan/size_cost.hpp"
#include <CLI/CLI.hpp>
#include <granum/core/error.hpp>

#include "cli/frame/frame.hpp"
#include "cli/frame/help.hpp"
#include "cli/frame/messages.hpp"
#include "scene_file.hpp"

namespace granum::cli {

void add_count(CLI::App& app, const std::string& name, std::optional<std::size_t>& target,
               const std::string& help) {
  const auto take = [name, &target](const long long& value) {
    if (value < 0)
      throw InvalidArgument(name, static_cast<double>(value), "", "[0, inf)");
    target = static_cast<std::size_t>(value);
  };
  app.add_option_function<long long>(name, take, help)->type_name("N");
}

void add_study_options(CLI::App& app, StudyOptions& options, studies::SceneCommand command) {
  add_path(app, "--scene", options.scene_file, "TOML file; without it the paper's six specimens")
      ->type_name("FILE");
  app.add_option("--set", options.settings, "Override one key, may be repeated: --set grain.radius=0.4mm")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  add_count(app, "--grains", options.grains, "Grains of a specimen");
  add_count(app, "--seeds", options.seeds, "Specimens of each kind");
  add_count(app, "--threads", options.threads, "Specimens side by side; the results do not depend on it");
  in_group(app, "Scene", {"--scene", "--set", "--grains", "--seeds", "--threads"});
  app.footer(key_help(command));
}

void ResultOptions::print(const std::string& report, const nlohmann::ordered_json& manifest) const {
  deliver({.json = json, .strict = false, .force = false, .out = {}}, within_width(report), manifest, {});
}

void add_result_options(CLI::App& app, ResultOptions& options, const std::string& out_help,
                        const std::string& json_help, const std::string& replaced) {
  add_path(app, "--out", options.out, out_help)->type_name("DIR");
  app.add_flag("--json", options.json, json_help);
  app.add_flag("--force", options.force, "Let --out replace " + replaced);
  app.add_flag("--quiet", options.quiet, "No progress line on a terminal");
  in_group(app, output_group, {"--out", "--json", "--force", "--quiet"});
}

void add_strict_scene(CLI::App& app, bool& strict) {
  app.add_flag("--strict", strict, "Do not begin (exit code 4) where a key of the scene is likely a slip");
  in_group(app, output_group, {"--strict"});
}

void say_cost_of_sizes(const studies::Scene& scene) {
  if (const std::string cost = studies::cost_of_sizes(scene); !cost.empty())
    say("note", cost);
}

nlohmann::ordered_json with_cost_of_sizes(nlohmann::ordered_json json, const studies::Scene& scene) {
  if (const std::string cost = studies::cost_of_sizes(scene); !cost.empty())
    json["notes"] = {cost};
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

} // namespace granum::cli
