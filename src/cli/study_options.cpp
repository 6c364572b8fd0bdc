// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_options.hpp"

#include <CLI/CLI.hpp>
#include <granum/core/error.hpp>

#include "scene_file.hpp"

namespace granum::cli {

namespace {

void add_count(CLI::App& command, const std::string& name, std::size_t& target, bool& given,
               const std::string& help) {
  const auto take = [name, &target, &given](const long long& value) {
    if (value < 0)
      throw InvalidArgument(name, static_cast<double>(value), "", "[0, inf)");
    target = static_cast<std::size_t>(value);
    given = true;
  };
  command.add_option_function<long long>(name, take, help)->type_name("N");
}

} // namespace

void add_study_options(CLI::App& command, StudyOptions& options) {
  command.add_option("--scene", options.scene_file, "TOML file; without it the paper's six specimens")
      ->type_name("FILE");
  command
      .add_option("--set", options.settings, "Override one key, may be repeated: --set grain.radius=0.4mm")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  add_count(command, "--grains", options.grains, options.grains_given, "Grains of a specimen");
  add_count(command, "--seeds", options.seeds, options.seeds_given, "Specimens of each kind");
  add_count(command, "--threads", options.threads, options.threads_given,
            "Specimens side by side; the results do not depend on it");
  command.footer(key_help());
}

verify::Scene resolve(const StudyOptions& options, const verify::Scene& base) {
  verify::Scene scene = options.scene_file.empty() ? base : read_scene(options.scene_file);
  for (const std::string& setting : options.settings)
    apply_setting(scene, setting);
  if (options.grains_given)
    scene.grains = options.grains;
  if (options.seeds_given)
    scene.seeds = options.seeds;
  if (options.threads_given)
    scene.threads = options.threads;
  verify::require_valid(scene);
  return scene;
}

} // namespace granum::cli
