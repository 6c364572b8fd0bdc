// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <memory>

#include "studies/plan/plan.hpp"
#include "studies/trade/trade_findings.hpp"
#include <fmt/core.h>
#include <granum/core/text.hpp>
#include <granum/io/csv/columns.hpp>
#include <granum/triaxial/specimen.hpp>

#include "cli/document/document.hpp"
#include "cli/options/likely_mistakes.hpp"
#include "cli/options/scene_file.hpp"
#include "cli/options/study_options.hpp"
#include "cli/verify/verify_document.hpp"

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

/// A number on the screen, in JSON, and in a column of CSV.
template <class Number>
void add(Items& to, const std::string& key, Number value, std::optional<io::ShownColumn> look = {},
         const std::string& before = "") {
  to.items.emplace_back(
      before + key, key, [value](const io::Only&) { return value; }, std::move(look));
}

Items plan_items(const studies::Scene& scene, const studies::Plan& plan) {
  Items list;
  add(list, "packings", plan.packings,
      shown("packings", fmt::format("of {} grains, frictionless", scene.study.grains)));
  add(list, "specimens", plan.specimens,
      shown("specimens with friction",
            fmt::format("through {} pressures each", scene.study.pressures.size())));
  add(list, "network_solutions", plan.network_solutions, shown("networks", "6 load cases each"));
  add(list, "probes", plan.probes, shown("cyclic shear probes"));
  add(list, "grain_steps", plan.grain_steps, shown("grain-steps", "about; grains times time steps"));
  add(list, "seconds_per_grain_step", plan.seconds_per_grain_step,
      io::ShownColumn{.heading = "time of a grain-step",
                      .digits = 3,
                      .unit = 1e-9,
                      .symbol = " ns",
                      .meaning = "measured now"});
  add(list, "predicted_time_s", plan.seconds,
      io::ShownColumn{.heading = "time",
                      .digits = 2,
                      .symbol = " s",
                      .meaning = "on " + threads_text(studies::thread_count(scene))});
  add(list, "predicted_memory_bytes", plan.memory,
      io::ShownColumn{.heading = "memory", .digits = 0, .fixed = true, .unit = 1e6, .symbol = " MB"});
  return list;
}

Items rule_items(const Rule& rule, const std::string& density, double wanted) {
  Items list{.key = "errors/" + density, .title = density};
  const std::string for_wanted = "for " + percent_text(wanted) + " of G", before = density + "_";
  add(list, "G", rule.modulus_error,
      io::ShownColumn{.heading = "error of G", .digits = 2, .unit = 0.01, .symbol = " %"}, before);
  add(list, "s", rule.exponent_error, shown("error of s"), before);
  add(list, "wanted_G", wanted, {}, before);
  add(list, "grains_for_wanted", rule.recipe.grains, shown("grains", for_wanted), before);
  add(list, "inertial_number_for_wanted", rule.recipe.inertial_number,
      shown("inertial number", for_wanted + ", at most"), before);
  add(list, "smallest_grains_measured", rule.smallest, {}, before);
  add(list, "largest_grains_measured", rule.largest, {}, before);
  io::add_item(list.items, "", fmt::format("{} to {}", rule.smallest, rule.largest),
               shown("laws measured for", "grains"));
  return list;
}

/// Where a number of grains is beyond the packings of the laws' fit.
void note_extrapolation(Document& to, const std::string& density, const Rule& rule, std::size_t grains,
                        const std::string& whose) {
  const auto count = static_cast<double>(grains);
  if (count < rule.smallest || count > rule.largest)
    to.add_notes(
        std::vector{fmt::format(
            "{}: the laws were measured on packings of {} to {} grains, and are extrapolated to the {} {}",
            density, rule.smallest, rule.largest, grains, whose)},
        Seen::always);
}

ExitCode run(const PlanOptions& options) {
  const studies::Scene scene = resolve(options.study, studies::SceneCommand::plan);
  say_cost_of_sizes(scene);
  Document to{.command = "plan", .title = "granum verify would run", .signs = ""};
  to.add(Seen::data, Data{"scene", json_of(scene)});
  to.add(Seen::always, plan_items(scene, studies::plan(scene, studies::measured_speed(scene))));
  to.add(Seen::always,
         Prose{{fmt::format(
             "standard errors due to the number of grains, the seeds and the strain rate, by laws "
             "measured on equal spheres (validation/trade); \"for {} of G\": what a standard "
             "error of G of this size requires; error of s: absolute, s of G ~ p^s",
             percent_text(options.error))}});
  for (const triaxial::Density density : scene.study.densities) {
    const Rule rule = rule_of(scene, density, options.error);
    const std::string of(studies::name(density));
    to.add(Seen::always, rule_items(rule, of, options.error));
    note_extrapolation(to, of, rule, scene.study.grains, "of the scene");
    note_extrapolation(to, of, rule, rule.recipe.grains,
                       "that " + percent_text(options.error) + " of G needs");
  }
  add_cost_of_sizes(to, scene);
  to.warnings = likely_mistakes(scene);
  return deliver(Outlets{.output = options.output}, to);
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
