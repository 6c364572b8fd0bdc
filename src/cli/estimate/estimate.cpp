// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate.hpp"

#include <memory>
#include <optional>

#include <fmt/core.h>
#include <granum/core/error.hpp>
#include <granum/core/number.hpp>
#include <granum/io/output_file.hpp>

#include "answer_picture.hpp"
#include "cli/frame/frame.hpp"
#include "cli/frame/help.hpp"
#include "cli/options/input_options.hpp"
#include "cli/options/likely_mistakes.hpp"
#include "cli/options/packing_json.hpp"

namespace granum::cli {

namespace {

using effective::State;
using nlohmann::ordered_json;

struct Options {
  InputValues inputs;
  std::vector<std::string> uncertain; ///< key=sd
  OutputOptions output;
  Number tolerance, cement;
  std::string picture, report; ///< files; empty for none
  bool bounds = false;         ///< show the uniform fields and rung 3 side by side
};

/// A line for each note, without repetitions: the assumptions of the answer and of the rungs.
std::string notes_text(const std::vector<std::string>& notes, const std::vector<std::string>& more) {
  std::string text = "\n";
  for (const std::string& note : notes)
    text += "- " + note + "\n";
  for (const std::string& note : more)
    text += "- " + note + "\n";
  return text;
}

Validity slips_of(const Options& o, const State& state) {
  Validity slips = likely_mistakes(o.inputs, state);
  if (o.tolerance.value > 1)
    slips.add(fmt::format("--tolerance {0} is {1}; did you mean {0}%?", short_text(o.tolerance.value),
                          percent_text(o.tolerance.value)));
  return slips;
}

ExitCode run(Options o) {
  require_free(o.output, o.picture);
  require_free({.json = false, .strict = false, .force = o.output.force, .out = o.report}, "");
  if (!o.report.empty() && !o.report.ends_with(".html"))
    throw InvalidArgument("--report = '" + o.report + "' must end in .html");
  o.inputs = estimate::completed(std::move(o.inputs));
  const AnswerCase answer = solve_answer(o.inputs, o.uncertain);
  const State& state = answer.answer.state();
  const Bounds bounds = bounds_of(answer);
  const ordered_json packing = packing_json(o.inputs, state);
  std::string table = state_text(packing, answer) + answer_table(answer);
  if (o.bounds)
    table += "\n" + bounds_table(state, bounds);
  table += notes_text(answer.assumptions, o.bounds ? bounds.assumptions : std::vector<std::string>{});
  ordered_json json = estimate_json(packing, bounds, answer);
  Validity validity = slips_of(o, state);
  if (o.bounds || answer.question.grain_shape == estimate::GrainShape::sphere) // a sand has measured laws
    validity.merge(bounds.validity);
  validity.merge(answer.answer.validity());
  if (answer.sand_answer)
    for (const std::string& note : answer.sand_answer->validity().notes)
      validity.add("sand: " + note);
  if (o.tolerance.given()) {
    const estimate::Ladder ladder = estimate::choose(answer.answer, o.tolerance.value);
    table += ladder_table(ladder);
    json["ladder"] = ladder_json(ladder);
    validity.merge(ladder.validity);
  }
  if (o.cement.given()) {
    const CementAnswer cemented = cement_answer(answer, o.cement.value);
    table += cement_table(cemented);
    json["cemented"] = cement_json(cemented);
    validity.merge(cemented.validity);
  }
  validity.keep_each_once();
  const bool csv = o.output.out.ends_with(".csv") && !o.output.json;
  std::optional<plot::Chart> chart;
  if (!o.picture.empty() || !o.report.empty())
    chart = answer_chart(o.inputs, o.uncertain, answer);
  const std::string text = within_width(table);
  const ExitCode code = deliver(o.output, csv ? answer_csv(answer, packing) : text, json, validity);
  if (!o.picture.empty())
    io::write_file(o.picture, plot::svg(*chart), existing(o.output.force));
  if (!o.report.empty())
    io::write_file(o.report, answer_page(answer, *chart, text, validity), existing(o.output.force));
  return code;
}

} // namespace

Command make_estimate() {
  auto options = std::make_shared<Options>();
  Command command{.name = "estimate",
                  .meaning =
                      "Small-strain stiffness and wave speeds of a packing at one state, with their range",
                  .notes = "Examples:\n"
                           "  granum estimate --void-ratio 0.6 --pressure 100kPa\n"
                           "  granum estimate --sand ottawa --relative-density 60% --pressure 100kPa\n"
                           "  granum estimate --void-ratio 0.7 --stress-v 200kPa --stress-h 100kPa",
                  .run = [options] { return run(*options); }};
  add_packing_options(command, options->inputs);
  add_answer_options(command, options->inputs);
  command.add(input_option(options->inputs, Input::k0));
  command.add(input_option(options->inputs, Input::shear_strain));
  command.add(
      "More results",
      {{.name = "--bounds",
        .value = flag(options->bounds),
        .meaning = "Also show three closed forms with their exponents: uniform strain (all grains move with "
                   "the mean strain), uniform stress (all contacts carry the forces of the mean stress), and "
                   "relaxed"},
       {.name = "--tolerance",
        .value = number_without_default(options->tolerance),
        .meaning =
            "Choose the cheapest closed form (rung) whose stated error is within this tolerance, such as 5%"},
       {.name = "--cement",
        .value = number_without_default(options->cement),
        .meaning = "Also show the packing with cement that fills this share of the total volume, such as 2%",
        .synonyms = {{"cementation bond"}}},
       uncertainty_row(options->uncertain)});
  add_output_options(command, options->output);
  add_picture(command, options->picture,
              "Draw G and its range over the mean stress, or over the shear strain with --strain");
  command.add(
      output_group,
      {{.name = "--report",
        .value = path(options->report, "FILE.html"),
        .meaning = "Write the answer as a page with range, assumptions, full references, and the picture"}});
  OptionRow& force = command.row("--force");
  force.needs = {{"--out --picture --report", "--out, --picture or --report"}};
  force.meaning = "Let --out, --picture and --report replace existing files";
  return command;
}

} // namespace granum::cli
