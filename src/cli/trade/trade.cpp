// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "studies/plan/plan.hpp"
#include <granum/core/error.hpp>
#include <granum/io/output_file.hpp>

#include "cli/frame/frame.hpp"
#include "cli/frame/long_work.hpp"
#include "cli/frame/messages.hpp"
#include "cli/options/likely_mistakes.hpp"
#include "cli/options/study_options.hpp"
#include "trade.hpp"

namespace granum::cli {

namespace {

using nlohmann::ordered_json;
namespace fs = std::filesystem;

struct TradeOptions {
  StudyOptions study;
  bool quick = false;
  bool full = false;
  std::optional<double> budget; ///< [s]
  bool strict = false;
  std::string redraw;
  ResultOptions results;
};

constexpr const char* file_names[] = {"trade.csv", "samples.csv", "trade.svg", "manifest.json",
                                      "report.html"};

studies::TradeScene scene_of(const TradeOptions& options) {
  studies::TradeScene trade = options.quick  ? studies::quick_trade()
                              : options.full ? studies::full_trade()
                                             : studies::default_trade();
  if (options.budget)
    trade.grains = studies::full_trade().grains;
  trade.scene = resolve(options.study, studies::SceneCommand::trade, trade.scene);
  trade = studies::with_enough_grains(std::move(trade));
  studies::require_valid(trade);
  if (options.budget)
    return studies::within_budget(trade, *options.budget, studies::measured_speed(trade.scene));
  return trade;
}

TradeOutcome run_study(const studies::TradeScene& trade, const std::atomic<bool>& stop, bool quiet) {
  const auto start = std::chrono::steady_clock::now();
  ProgressLine line(quiet);
  TradeOutcome outcome{.trade = trade, .samples = {}, .rows = {}};
  outcome.samples = studies::run_trade(
      trade, {.report = [&line](const studies::Progress& p) { line.show(p); }, .stop = &stop});
  outcome.seconds = seconds_since(start);
  outcome.rows = studies::trade_rows(outcome.samples);
  outcome.failures = studies::failures_text(outcome.samples);
  return outcome;
}

void write_results(const fs::path& folder, const TradeOutcome& outcome, const Document& document,
                   const ordered_json& manifest, io::Existing existing) {
  const Document rows = rows_document(outcome.rows);
  io::write_file(folder / file_names[0], csv(rows), existing);
  io::write_file(folder / file_names[1], csv(samples_document(outcome)), existing);
  io::write_file(folder / file_names[2], picture(rows), existing);
  io::write_file(folder / file_names[3], json_text(manifest), existing);
  io::write_file(folder / file_names[4], page(document), existing);
}

/// Draws the picture of a finished run again.
ExitCode draw_again(const TradeOptions& options) {
  const StudyOptions& study = options.study;
  if (options.quick || options.full || options.budget || !study.scene_file.empty() ||
      !study.settings.empty() || study.grains || study.seeds || !options.results.out.empty())
    throw InvalidArgument("--redraw uses the earlier run; no scene, extent or other folder may be "
                          "given with it");
  const fs::path folder = options.redraw, picture = folder / file_names[2];
  io::write_file(picture, cli::picture(rows_document(read_trade_rows(folder / file_names[0]))),
                 io::Existing::replace);
  options.results.print("picture in " + picture.string() + "\n", {{"picture", picture.string()}});
  return ExitCode::ok;
}

ExitCode run(const TradeOptions& options) {
  if (!options.redraw.empty())
    return draw_again(options);
  const studies::TradeScene trade = scene_of(options);
  if (refuses(likely_mistakes(trade.scene), options.strict))
    return ExitCode::not_converged;
  say_cost_of_sizes(trade.scene);
  const std::atomic<bool>& stop = listen_for_stop();
  const ResultOptions& results = options.results;
  const bool writes = results.writes_files();
  const fs::path folder =
      writes ? results_folder(results.out, "trade", file_names, results.force) : fs::path();
  const TradeOutcome outcome = run_study(trade, stop, results.quiet);
  const Document document = trade_document(outcome, options.study);
  const ordered_json manifest = with_cost_of_sizes(
      with_warnings(json(document), likely_mistakes(outcome.trade.scene)), outcome.trade.scene);
  if (writes)
    write_results(folder, outcome, document, manifest, results.existing());
  const std::string where =
      writes ? "report.html, CSV, picture and manifest in " + folder.string() + "\n" : "";
  results.print(screen(document, false) + where, manifest);
  if (outcome.failures.empty())
    return ExitCode::ok;
  if (stop)
    return exit_code_of_stop();
  say("error", outcome.failures);
  const auto failed =
      std::count_if(outcome.samples.begin(), outcome.samples.end(),
                    [](const studies::TradeSample& sample) { return !sample.failure.empty(); });
  return code_of_failed(static_cast<std::size_t>(failed), outcome.samples.size());
}

} // namespace

Command make_trade() {
  auto options = std::make_shared<TradeOptions>();
  Command command{
      .name = "trade",
      .meaning = "Measure speed against accuracy on this machine: grains, rates, time step, probe, walls",
      .run = [options] { return run(*options); }};
  add_study_options(command, options->study, studies::SceneCommand::trade);
  command.add("Extent", {{.name = "--quick",
                          .value = flag(options->quick),
                          .meaning = "Up to 1,000 grains, few values of each setting, two seeds",
                          .excludes = {{"--full --budget", "--quick cannot go with --full or --budget"}}},
                         {.name = "--full",
                          .value = flag(options->full),
                          .meaning = "Up to 16,000 grains, and more values of every setting"},
                         {.name = "--budget",
                          .value = quantity(options->budget, Dimension::time),
                          .meaning = "Largest numbers of grains within this wall time: --budget 600s"}});
  command.add("Run", {{.name = "--redraw",
                       .value = path(options->redraw, "DIR"),
                       .meaning = "Draw trade.svg again from the finished run of this folder"}});
  add_strict_scene(command, options->strict);
  add_result_options(command, options->results, "Folder for results; by default a new granum-trade-N");
  return command;
}

} // namespace granum::cli
