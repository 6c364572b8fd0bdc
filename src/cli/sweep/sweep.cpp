// SPDX-License-Identifier: GPL-3.0-or-later
#include "sweep.hpp"

#include <algorithm>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <granum/core/error.hpp>

namespace granum::cli {

namespace {

/// The rungs that were asked for, or all that the options allow.
Rungs chosen_rungs(const SweepOptions& o) {
  const bool z_given = o.packing.mechanical_coordination_number.given() || o.packing.rattler_fraction.given();
  Rungs rungs;
  for (const Rung& rung : effective::closed_forms()) {
    const bool asked_for = std::find(o.rungs.begin(), o.rungs.end(), rung.key) != o.rungs.end();
    const bool allowed = !rung.needs_coordination || z_given;
    if (asked_for && !allowed && o.table.empty())
      throw InvalidArgument(fmt::format("--rungs {} needs --mechanical-coordination-number or "
                                        "--rattler-fraction",
                                        rung.key));
    if (asked_for || (o.rungs.empty() && allowed))
      rungs.push_back(&rung);
  }
  return rungs;
}

std::string rungs_help() {
  std::string text = "Rungs:\n";
  for (const Rung& rung : effective::closed_forms())
    text += fmt::format("  {:<15} {}; needs {}\n", rung.key, rung.description, rung.needs);
  return text + "Columns of a table are named like the options, with underscores and the unit: void_ratio,\n"
                "stress_v_kPa; or by symbol: e, C_n, a, p_kPa, sigma_v_kPa, sigma_h_kPa.";
}

template <class Item>
std::vector<std::string> names_of(std::span<const Item> items, const char* Item::*member) {
  std::vector<std::string> names;
  for (const Item& item : items)
    names.emplace_back(item.*member);
  return names;
}

std::vector<CLI::Option*> add_path_options(CLI::App& command, SweepOptions& o) {
  return {command.add_option("--path", o.path, "Stress path; all but iso start isotropic and go to --eta")
              ->check(CLI::IsMember({"iso", "txc", "rtxc", "rtxe", "txe"}))
              ->capture_default_str(),
          add_number_without_default(command, "--from", o.from, "Mean stress at the start"),
          add_number_without_default(command, "--to", o.to, "Mean stress at the end, iso"),
          add_number_without_default(command, "--eta", o.eta, "q/p' at the end; negative for rtxe and txe"),
          add_number_without_default(command, "--friction-angle", o.friction_angle,
                                     "End at failure of a material of this angle, instead of --eta"),
          command.add_option("--points", o.points, "States on the path, both ends included")
              ->check(CLI::Range(2, 1000000))
              ->capture_default_str(),
          command
              .add_option("--spacing", o.spacing,
                          "Of the states, in p' or eta; by default log for iso, linear for others")
              ->check(CLI::IsMember({"log", "linear"}))};
}

void add_sweep_options(CLI::App& command, SweepOptions& o) {
  add_packing_options(command, o.packing);
  command.add_option("--rungs", o.rungs, "Closed forms, separated by commas")
      ->delimiter(',')
      ->check(CLI::IsMember(names_of(effective::closed_forms(), &Rung::key)))
      ->default_str("all, 3 if z* is an option");
  const std::vector<CLI::Option*> path_options = add_path_options(command, o);
  CLI::Option* table =
      command.add_option("--table", o.table, "States from the rows of this CSV file")->type_name("FILE.csv");
  for (CLI::Option* option : path_options)
    table->excludes(option);
  add_output_options(command, o.output);
  CLI::Option* picture = command
                             .add_option("--picture", o.picture,
                                         "Draw the path; with a gnuplot script beside it that draws --out")
                             ->type_name("FILE.svg")
                             ->needs("--out")
                             ->excludes("--json")
                             ->excludes(table);
  command.add_option("--picture-of", o.picture_of, "What the picture shows")
      ->check(CLI::IsMember(names_of(swept_quantities(), &SweptQuantity::name)))
      ->capture_default_str()
      ->needs(picture);
}

} // namespace

Command add_sweep(CLI::App& program) {
  auto options = std::make_shared<SweepOptions>();
  CLI::App* command = program.add_subcommand(
      "sweep", "Closed-form stiffness along a stress path, or for each row of a table: CSV");
  add_sweep_options(*command, *options);
  command->footer(rungs_help());
  return {command, [options] {
            const Rungs rungs = chosen_rungs(*options);
            return options->table.empty() ? sweep_path(*options, rungs) : sweep_table(*options, rungs);
          }};
}

} // namespace granum::cli
