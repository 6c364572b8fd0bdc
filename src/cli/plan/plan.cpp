// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <memory>

#include "studies/plan/plan.hpp"
#include "studies/trade/trade_rule.hpp"
#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <granum/core/number.hpp>
#include <granum/triaxial/specimen.hpp>

#include "cli/frame/frame.hpp"
#include "cli/frame/help.hpp"
#include "cli/options/likely_mistakes.hpp"
#include "cli/options/scene_file.hpp"
#include "cli/options/study_options.hpp"

namespace granum::cli {

namespace {

struct PlanOptions {
  StudyOptions study;
  OutputOptions output;
  double error = 0.01; ///< wanted, of G [1]
};

/// What is expected of one density, and what the wanted error of G would take.
struct Rule {
  double modulus_error;
  double exponent_error;
  studies::Recipe recipe;
  double smallest; ///< grains that the laws were measured with
  double largest;
};

Rule rule_of(const studies::Scene& scene, triaxial::Density density, double error) {
  const studies::TradeLaws& laws = studies::recorded_laws();
  const bool dense = density == triaxial::Density::dense;
  const studies::ErrorLaw& modulus = dense ? laws.dense_modulus : laws.loose_modulus;
  const studies::ErrorLaw& exponent = dense ? laws.dense_exponent : laws.loose_exponent;
  const double inertial_number = triaxial::compression_options().inertial_number;
  studies::Recipe recipe = studies::recipe_for(modulus, error, scene.study.seeds);
  recipe.grains = std::max(recipe.grains, triaxial::least_grains(scene.grain.sizes));
  return {studies::expected_error(modulus, scene.study.grains, scene.study.seeds, inertial_number),
          studies::expected_error(exponent, scene.study.grains, scene.study.seeds, inertial_number), recipe,
          modulus.size.smallest, modulus.size.largest};
}

std::string rule_lines(const PlanOptions& options, const studies::Scene& scene) {
  std::string text =
      "errors that size, seeds and rate leave, by the laws of validation/trade (equal spheres):\n";
  for (const triaxial::Density density : scene.study.densities) {
    const Rule rule = rule_of(scene, density, options.error);
    text += fmt::format("  {}: G {}, s {:.4f}; for {} of G {} grains and inertial numbers up to {} (measured "
                        "with {} to {})\n",
                        studies::name(density), percent_text(rule.modulus_error), rule.exponent_error,
                        percent_text(options.error), rule.recipe.grains,
                        short_text(rule.recipe.inertial_number, 2), short_text(rule.smallest),
                        short_text(rule.largest));
  }
  return text;
}

ExitCode run(const PlanOptions& options) {
  const studies::Scene scene = resolve(options.study, studies::SceneCommand::plan);
  say_cost_of_sizes(scene);
  const studies::Plan plan = studies::plan(scene, studies::measured_speed(scene));
  nlohmann::ordered_json json = with_cost_of_sizes(json_head("plan"), scene);
  json["scene"] = json_of(scene);
  json["packings"] = plan.packings;
  json["specimens"] = plan.specimens;
  json["network_solutions"] = plan.network_solutions;
  json["probes"] = plan.probes;
  json["grain_steps"] = plan.grain_steps;
  json["seconds_per_grain_step"] = plan.seconds_per_grain_step;
  json["predicted_time_s"] = plan.seconds;
  json["predicted_memory_bytes"] = plan.memory;
  for (const triaxial::Density density : scene.study.densities) {
    const Rule rule = rule_of(scene, density, options.error);
    json["errors"][std::string(studies::name(density))] = {
        {"G", rule.modulus_error},
        {"s", rule.exponent_error},
        {"wanted_G", options.error},
        {"grains_for_wanted", rule.recipe.grains},
        {"inertial_number_for_wanted", rule.recipe.inertial_number},
        {"smallest_grains_measured", rule.smallest},
        {"largest_grains_measured", rule.largest}};
  }
  const std::string table = fmt::format(
      "granum verify would run\n"
      "  {:6} frictionless packings of {} grains (positions only: no rotations, no contact memory)\n"
      "  {:6} specimens with friction, each through {} pressures\n"
      "  {:6} networks solved, 6 load cases each\n"
      "  {:6} cyclic shear probes\n"
      "in about {:.3g} grain-steps: {:.0f} s at {:.0f} ns each, measured now, on {} threads; {:.0f} MB\n",
      plan.packings, scene.study.grains, plan.specimens, scene.study.pressures.size(), plan.network_solutions,
      plan.probes, plan.grain_steps, plan.seconds, 1e9 * plan.seconds_per_grain_step,
      studies::thread_count(scene), plan.memory / 1e6);
  return deliver(options.output, table + rule_lines(options, scene), json, likely_mistakes(scene));
}

} // namespace

Command add_plan(CLI::App& program) {
  auto options = std::make_shared<PlanOptions>();
  CLI::App* command =
      program.add_subcommand("plan", "What verify would run, its predicted time, memory and error");
  add_study_options(*command, options->study, studies::SceneCommand::plan);
  add_quantity(*command, "--error", options->error, Dimension::dimensionless,
               "Wanted error of G, from which grains and inertial number follow: --error 2%");
  in_group(*command, "Plan", {"--error"});
  add_output_options(*command, options->output);
  return {command, [options] { return run(*options); }};
}

} // namespace granum::cli
