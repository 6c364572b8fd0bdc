// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate.hpp"

#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include "frame.hpp"
#include "ladder_report.hpp"
#include "packing_options.hpp"
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

/// Of a stiffness that is not positive definite, Young's moduli are the limit or do not exist.
void note_missing_young_moduli(const FieldAnswer& answer, const char* hypothesis, Validity& validity) {
  if (!young_modulus(answer.stiffness, Loading::vertical))
    validity.add(fmt::format("Young's moduli under {} do not exist: the stiffness is not positive definite",
                             hypothesis));
}

EstimateAnswer solve(const Packing& packing) {
  EstimateAnswer all{.uniform_strain = answer(uniform_strain_rung(), packing),
                     .uniform_stress = answer(uniform_stress_rung(), packing),
                     .relaxed = std::nullopt,
                     .validity = {}};
  all.validity.merge(all.uniform_strain.validity);
  all.validity.merge(all.uniform_stress.validity);
  note_missing_young_moduli(all.uniform_strain, "uniform strain", all.validity);
  note_missing_young_moduli(all.uniform_stress, "uniform stress", all.validity);
  if (packing.mechanical_coordination_number) {
    all.relaxed = answer(relaxed_rung(), packing);
    all.validity.merge(all.relaxed->validity);
  }
  keep_each_once(all.validity);
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
    keep_each_once(validity);
  }
  return deliver(options.output, table, json, validity);
}

} // namespace

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
