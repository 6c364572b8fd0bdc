// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <memory>

#include "studies/plan/plan.hpp"
#include "studies/trade/trade_findings.hpp"
#include <fmt/core.h>
#include <granum/core/text.hpp>
#include <granum/io/csv/columns.hpp>
#include <granum/triaxial/specimen.hpp>

#include "cli/frame/frame.hpp"
#include "cli/frame/help.hpp"
#include "cli/frame/json_members.hpp"
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

/// Expected errors of one density, and the settings for the required error of G.
struct Rule {
  double modulus_error;
  double exponent_error;
  studies::Recipe recipe;
  double smallest; ///< range of grain numbers of the measured laws
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

/// A line of the planned work: number first.
io::ShownColumn shown(std::string label, std::string meaning = "") {
  return {.heading = std::move(label), .digits = 3, .meaning = std::move(meaning)};
}

io::Items plan_items(const studies::Scene& scene, const studies::Plan& plan) {
  io::Items list;
  const auto grains = fmt::format("of {} grains, frictionless", scene.study.grains);
  const auto pressures = fmt::format("through {} pressures each", scene.study.pressures.size());
  io::add_item(list, "packings", plan.packings, shown("packings", grains));
  io::add_item(list, "specimens", plan.specimens, shown("specimens with friction", pressures));
  io::add_item(list, "network_solutions", plan.network_solutions, shown("networks", "6 load cases each"));
  io::add_item(list, "probes", plan.probes, shown("cyclic shear probes"));
  io::add_item(list, "grain_steps", plan.grain_steps, shown("grain-steps", "about; grains times time steps"));
  io::add_item(list, "seconds_per_grain_step", plan.seconds_per_grain_step,
               io::ShownColumn{.heading = "time of a grain-step",
                               .digits = 3,
                               .unit = 1e-9,
                               .symbol = " ns",
                               .meaning = "measured now"});
  io::add_item(list, "predicted_time_s", plan.seconds,
               io::ShownColumn{.heading = "time",
                               .digits = 2,
                               .symbol = " s",
                               .meaning = "on " + threads_text(studies::thread_count(scene))});
  io::add_item(
      list, "predicted_memory_bytes", plan.memory,
      io::ShownColumn{.heading = "memory", .digits = 0, .fixed = true, .unit = 1e6, .symbol = " MB"});
  return list;
}

io::Items rule_items(const Rule& rule, double wanted) {
  io::Items list;
  const io::ShownColumn percent{.heading = "error of G", .digits = 2, .unit = 0.01, .symbol = " %"};
  const std::string for_wanted = "for " + percent_text(wanted) + " of G";
  io::add_item(list, "G", rule.modulus_error, percent);
  io::add_item(list, "s", rule.exponent_error, shown("error of s"));
  io::add_item(list, "wanted_G", wanted);
  io::add_item(list, "grains_for_wanted", rule.recipe.grains, shown("grains", for_wanted));
  io::add_item(list, "inertial_number_for_wanted", rule.recipe.inertial_number,
               shown("inertial number", for_wanted + ", at most"));
  io::add_item(list, "smallest_grains_measured", rule.smallest);
  io::add_item(list, "largest_grains_measured", rule.largest);
  io::add_item(list, "", fmt::format("{} to {}", rule.smallest, rule.largest),
               shown("laws measured for", "grains"));
  return list;
}

ExitCode run(const PlanOptions& options) {
  const studies::Scene scene = resolve(options.study, studies::SceneCommand::plan);
  say_cost_of_sizes(scene);
  const io::Items items = plan_items(scene, studies::plan(scene, studies::measured_speed(scene)));
  nlohmann::ordered_json json = with_cost_of_sizes(json_head("plan"), scene);
  json["scene"] = json_of(scene);
  put_members(json, items, io::Only{});
  std::string text =
      "granum verify would run\n" + io::list_text(items, io::Only{}) +
      "standard errors due to the number of grains, the seeds and the strain rate, by laws measured on "
      "equal spheres (validation/trade); \"for " +
      percent_text(options.error) +
      " of G\": what a standard error of G of this size requires; error of s: absolute, s of G ~ p^s\n";
  for (const triaxial::Density density : scene.study.densities) {
    const io::Items rule = rule_items(rule_of(scene, density, options.error), options.error);
    const std::string name(studies::name(density));
    json["errors"][name] = members(rule, io::Only{});
    text += name + "\n" + io::list_text(rule, io::Only{});
  }
  return deliver(options.output, within_width(text), json, likely_mistakes(scene));
}

} // namespace

Command make_plan() {
  auto options = std::make_shared<PlanOptions>();
  Command command{.name = "plan",
                  .meaning = "Predicted time, memory and error of a run of verify",
                  .run = [options] { return run(*options); }};
  add_study_options(command, options->study, studies::SceneCommand::plan);
  Value error = quantity(options->error, Dimension::dimensionless);
  error.by_default = "1%";
  command.add(
      "Plan",
      {{.name = "--error",
        .value = std::move(error),
        .meaning = "Required error of G; gives the number of grains and the inertial number: --error 2%"}});
  add_output_options(command, options->output);
  return command;
}

} // namespace granum::cli
