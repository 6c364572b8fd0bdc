// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate.hpp"

#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <granum/core/number.hpp>

#include "answer_options.hpp"
#include "answer_report.hpp"
#include "cli/frame/frame.hpp"
#include "cli/frame/help.hpp"
#include "cli/options/likely_mistakes.hpp"
#include "cli/options/packing_options.hpp"
#include "ladder_report.hpp"
#include "uncertainty.hpp"

namespace granum::cli {

namespace {

using effective::State;
using nlohmann::ordered_json;

struct Options {
  PackingOptions packing;
  AnswerOptions answer;
  std::vector<std::string> uncertain; ///< key=sd
  OutputOptions output;
  Number tolerance;
  bool bounds = false; ///< show the uniform fields and rung 3 side by side
};

EstimateCase resolve(const PackingOptions& o) {
  const State state = resolve_state(o, resolve_stresses(o));
  EstimateCase question{.subject = {state, resolve_mechanical_coordination_number(o)},
                        .packing = packing_json(o, state),
                        .assumptions = assumed_inputs(o, state)};
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

/// What --uncertainty says of the packing itself: the density of the grains changes wave speeds alone.
std::vector<std::string> of_packing(std::vector<std::string> settings) {
  std::erase_if(settings, [](const std::string& setting) { return setting.starts_with("grain-density="); });
  return settings;
}

/// What the rungs assume of contacts, where they are not given, is what the answer found: one packing, one
/// number of contacts.
std::vector<std::string> take_contacts(PackingOptions& packing, const effective::PackingAnswer& answer) {
  if (packing.coordination_number.given())
    return {};
  packing.coordination_number.value = answer.coordination_number.value;
  packing.coordination_number.preset = packing.mechanical_coordination_number.given(); // z* tells C_n
  return {fmt::format("bounds and rungs take the contacts of the answer, C_n = {} of {} to {}; "
                      "--coordination-number tells others",
                      short_text(answer.coordination_number.value, 3),
                      short_text(answer.coordination_number.low, 3),
                      short_text(answer.coordination_number.high, 3))};
}

ExitCode run(Options options) {
  apply_presets(options.packing, options.answer);
  const AnswerCase answer = solve_answer(options.packing, options.answer, options.uncertain);
  const std::vector<std::string> contacts = take_contacts(options.packing, answer.answer);
  EstimateCase question = resolve(options.packing);
  question.assumptions.insert(question.assumptions.end(), contacts.begin(), contacts.end());
  EstimateAnswer rungs = solve(question.subject);
  const std::vector<std::string> uncertain = of_packing(options.uncertain);
  std::optional<UncertaintyAnswer> uncertainty;
  if (!uncertain.empty()) {
    uncertainty = propagate(options.packing, uncertain);
    rungs.validity.merge(uncertainty->validity);
  }
  std::string table = state_text(question) + answer_table(answer);
  if (options.bounds)
    table += "\n" + rungs_table(question, rungs);
  table +=
      notes_table(answer.assumptions, options.bounds ? question.assumptions : std::vector<std::string>{});
  ordered_json json = estimate_json(question, rungs, answer);
  Validity validity = likely_mistakes(options.packing, question.subject.state);
  validity.merge(likely_mistakes(options.answer.grain_density));
  if (options.tolerance.value > 1)
    validity.add(fmt::format("--tolerance {0} is {1}; was {0}% meant?", short_text(options.tolerance.value),
                             percent_text(options.tolerance.value)));
  validity.merge(rungs.validity);
  validity.merge(answer.answer.validity);
  validity.keep_each_once();
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
      "estimate", "Small-strain stiffness and wave speeds of a packing at one state, with their range");
  add_packing_options(*command, options->packing);
  add_answer_options(*command, options->answer);
  command->add_flag("--bounds", options->bounds,
                    "Also uniform strain, uniform stress and the relaxed rung side by side, with exponents");
  add_number_without_default(*command, "--tolerance", options->tolerance,
                             "Choose the cheapest rung whose stated error is no larger, e.g. 5%");
  add_uncertainty_option(*command, options->uncertain);
  in_group(*command, "More results", {"--bounds", "--tolerance", "--uncertainty"});
  add_output_options(*command, options->output);
  command->footer("Examples:\n"
                  "  granum estimate --void-ratio 0.6 --pressure 100kPa\n"
                  "  granum estimate --sand ottawa --relative-density 60% --pressure 100kPa\n"
                  "  granum estimate --void-ratio 0.7 --stress-v 200kPa --stress-h 100kPa");
  return {command, [options] { return run(*options); }};
}

} // namespace granum::cli
