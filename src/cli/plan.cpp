// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <granum/verify/plan.hpp>

#include "frame.hpp"
#include "scene_file.hpp"
#include "study_options.hpp"

namespace granum::cli {

namespace {

struct Options {
  StudyOptions study;
  OutputOptions output;
};

ExitCode run(const Options& options) {
  const verify::Scene scene = resolve(options.study);
  const verify::Plan plan = verify::plan(scene);
  nlohmann::ordered_json json = json_head("plan");
  json["scene"] = json_of(scene);
  json["packings"] = plan.packings;
  json["specimens"] = plan.specimens;
  json["network_solutions"] = plan.network_solutions;
  json["probes"] = plan.probes;
  json["grain_steps"] = plan.grain_steps;
  json["seconds_per_grain_step"] = plan.seconds_per_grain_step;
  json["predicted_time_s"] = plan.seconds;
  json["predicted_memory_bytes"] = plan.memory;
  const std::string table = fmt::format(
      "granum verify would run\n"
      "  {:6} frictionless packings of {} grains (positions only: no rotations, no contact memory)\n"
      "  {:6} specimens with friction, each through {} pressures\n"
      "  {:6} networks solved, 6 load cases each\n"
      "  {:6} cyclic shear probes\n"
      "in about {:.3g} grain-steps: {:.0f} s at {:.0f} ns each, measured now, on {} threads; {:.0f} MB\n",
      plan.packings, scene.grains, plan.specimens, scene.pressures.size(), plan.network_solutions,
      plan.probes, plan.grain_steps, plan.seconds, 1e9 * plan.seconds_per_grain_step,
      verify::thread_count(scene), plan.memory / 1e6);
  return deliver(options.output, table, json, {});
}

} // namespace

Command add_plan(CLI::App& program) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("plan", "What verify would run, and its predicted time and memory");
  add_study_options(*command, options->study);
  add_output_options(*command, options->output);
  return {command, [options] { return run(*options); }};
}

} // namespace granum::cli
