// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate.hpp"

#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include "cli/frame/frame.hpp"
#include "cli/options/packing_options.hpp"
#include "ladder_report.hpp"
#include "uncertainty.hpp"

namespace granum::cli {

namespace {

using effective::State;

struct Options {
  PackingOptions packing;
  std::vector<std::string> uncertain; ///< key=sd
  OutputOptions output;
  Number tolerance;
};

EstimateCase resolve(const PackingOptions& o) {
  const State state = resolve_state(o, resolve_stresses(o));
  EstimateCase question{.subject = {state, resolve_mechanical_coordination_number(o)},
                        .packing = packing_json(o, state),
                        .assumptions = assumed_inputs(o, state)};
  for (const std::string& note : loose_packing_remark(o, state))
    question.assumptions.push_back(note);
  if (state.stress_v == 0 && state.stress_h == 0)
    question.assumptions.emplace_back("m, n and s at zero stress are their limit on the isotropic path");
  if (state.coordination_number == 0)
    question.assumptions.emplace_back(
        "m, n and s do not exist: without contacts every modulus is 0 at any stress");
  return question;
}

EstimateAnswer solve(const effective::RungInputs& packing) {
  EstimateAnswer all;
  for (const ShownForm& form : shown_forms(packing)) {
    all.forms.push_back({form, effective::answer_with_exponents(*form.rung, packing)});
    const effective::RungAnswer& answer = all.forms.back().answer;
    all.validity.merge(answer.validity);
    const bool own_note = form.rung->name != effective::RungName::relaxed; // stable where uniform strain is
    if (own_note && !elastic::young_modulus(answer.stiffness, elastic::Loading::vertical))
      all.validity.add(fmt::format(
          "Young's moduli under {} do not exist: the stiffness is not positive definite", form.title));
  }
  all.validity.keep_each_once();
  return all;
}

ExitCode run(const Options& options) {
  const EstimateCase question = resolve(options.packing);
  EstimateAnswer answer = solve(question.subject);
  std::optional<UncertaintyAnswer> uncertainty;
  if (!options.uncertain.empty()) {
    uncertainty = propagate(options.packing, options.uncertain);
    answer.validity.merge(uncertainty->validity);
  }
  std::string table = estimate_table(question, answer);
  nlohmann::ordered_json json = estimate_json(question, answer);
  Validity validity = answer.validity;
  if (uncertainty) {
    table += uncertainty_table(*uncertainty);
    json["uncertainty"] = uncertainty_json(*uncertainty);
  }
  if (options.tolerance.given()) {
    const effective::LadderEstimate ladder =
        choose_rung(options.packing, question.subject.state, options.tolerance.value);
    table += ladder_table(ladder);
    json["ladder"] = ladder_json(ladder);
    validity.merge(ladder.validity);
    validity.keep_each_once();
  }
  return deliver(options.output, table, json, validity);
}

} // namespace

std::vector<ShownForm> shown_forms(const effective::RungInputs& packing) {
  using effective::RungName;
  std::vector<ShownForm> forms{
      {"uniform_strain", "uniform strain", &effective::rung(RungName::directional)},
      {"uniform_stress", "uniform stress", &effective::rung(RungName::uniform_stress)},
      {"relaxed", "relaxed", &effective::rung(RungName::relaxed)}};
  std::erase_if(forms, [&](const ShownForm& form) { return !effective::has_inputs(packing, *form.rung); });
  return forms;
}

Command add_estimate(CLI::App& program) {
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "estimate", "Closed-form stiffness of a packing at one state, and how it grows with stress");
  add_packing_options(*command, options->packing);
  add_number_without_default(*command, "--tolerance", options->tolerance,
                             "Choose the cheapest rung whose stated error is no larger, e.g. 5%");
  add_uncertainty_option(*command, options->uncertain);
  add_output_options(*command, options->output);
  return {command, [options] { return run(*options); }};
}

} // namespace granum::cli
