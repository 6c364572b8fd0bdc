// SPDX-License-Identifier: GPL-3.0-or-later
#include "depth.hpp"

#include <algorithm>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <granum/core/error.hpp>

#include "cli/frame/help.hpp"

namespace granum::cli {

namespace {

using effective::Rung;

/// The rungs that were asked for, or all of them.
Rungs chosen_rungs(const SweepOptions& o) {
  const bool by_default = o.table.empty() || o.all_columns || o.output.json;
  Rungs rungs;
  for (const Rung& rung : effective::closed_forms())
    if (std::find(o.rungs.begin(), o.rungs.end(), rung.key) != o.rungs.end() ||
        (o.rungs.empty() && by_default))
      rungs.push_back(&rung);
  return rungs;
}

std::string rungs_help() {
  std::string text = "Rungs:\n";
  for (const Rung& rung : effective::closed_forms())
    text += fmt::format("  {:<15} {}; needs {}\n", rung.key, rung.description, rung.needs);
  return text +
         "Columns of a table are named like the options, with their unit: void_ratio, stress_v_kPa,\n"
         "\"stress v (kPa)\"; or by symbol: e, p_kPa, sigma_v [kPa], C_n, z_star, a, C_u, D_r. Texts are\n"
         "contact, sizes, preparation, grain, sand. Semicolons between columns allow decimal commas.";
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
              ->transform(one_of({"iso", "txc", "rtxc", "rtxe", "txe"}))
              ->capture_default_str(),
          add_number_without_default(command, "--from", o.from, "Mean stress at the start"),
          add_number_without_default(command, "--to", o.to, "Mean stress at the end, iso"),
          add_number_without_default(command, "--eta", o.eta, "q/p' at the end; negative for rtxe and txe"),
          add_number_without_default(command, "--friction-angle", o.friction_angle,
                                     "End at failure of a material of this angle, instead of --eta"),
          command.add_option("--points", o.points, "States on the path, or depths, both ends included")
              ->check(CLI::Range(2, 1000000))
              ->capture_default_str(),
          command
              .add_option("--spacing", o.spacing,
                          "Of the states, in p' or eta; by default log for iso, linear for others")
              ->transform(one_of({"log", "linear"}))};
}

void add_picture_options(CLI::App& command, SweepOptions& o, CLI::Option* depth, CLI::Option* table) {
  CLI::Option* picture =
      add_picture(
          command, o.picture,
          "Draw the answer with its range and the rungs along the path; stresses and answers over depth; "
          "or G of a table's rows")
          ->excludes("--json");
  command.add_option("--picture-of", o.picture_of, "What the picture of a path shows; by default G_hv")
      ->transform(one_of(names_of(swept_quantities(), &SweptQuantity::name)))
      ->needs(picture)
      ->excludes(depth)
      ->excludes(table);
}

void add_sweep_options(CLI::App& command, SweepOptions& o) {
  add_packing_options(command, o.packing);
  add_answer_options(command, o.answer);
  add_strain_option(command, o.answer);
  CLI::Option* rungs = command.add_option("--rungs", o.rungs, "Closed forms, separated by commas")
                           ->delimiter(',')
                           ->transform(one_of(names_of(effective::closed_forms(), &Rung::key)))
                           ->default_str("all; none in the CSV of a table");
  const std::vector<CLI::Option*> path_options = add_path_options(command, o);
  CLI::Option* table =
      command.add_option("--table", o.table, "States from the rows of this CSV file")->type_name("FILE.csv");
  add_ground_options(command, o.ground);
  CLI::Option* depth = command.get_option("--depth");
  for (CLI::Option* option : path_options) {
    table->excludes(option);
    if (option->get_name() != "--points")
      depth->excludes(option);
  }
  depth->excludes(table)->excludes(rungs);
  command
      .add_option_function<std::string>(
          "--columns", [&o](const std::string& text) { o.all_columns = text == "all"; },
          "In CSV: G, V_s, V_p, z* and s of the answer with their ranges, or all moduli and speeds, and "
          "every rung of a table")
      ->transform(one_of({"usual", "all"}))
      ->default_str("usual");
  command.add_flag("--laws", o.law_columns,
                   "Published laws of sands too: a column each, lines in the picture of a path");
  add_output_options(command, o.output);
  add_picture_options(command, o, depth, table);
}

void group_sweep_options(CLI::App& command) {
  in_group(command, "Path",
           {"--path", "--from", "--to", "--eta", "--friction-angle", "--spacing", "--points"});
  in_group(command, "Ground",
           {"--depth", "--unit-weight", "--saturated-unit-weight", "--water-table", "--k0", "--surcharge",
            "--water-unit-weight"});
  in_group(command, "Table and columns", {"--table", "--columns", "--laws", "--rungs"});
  in_group(command, output_group, {"--picture", "--picture-of"});
}

ExitCode run(SweepOptions o) {
  const bool by_path = o.table.empty() && o.ground.depth.empty();
  o.answer.ground = !o.ground.depth.empty();
  if (!o.table.empty())
    return sweep_table(o, chosen_rungs(o));
  apply_presets(o.packing, o.answer);
  return by_path ? sweep_path(o, chosen_rungs(o)) : sweep_depth(o);
}

} // namespace

Command add_sweep(CLI::App& program) {
  auto options = std::make_shared<SweepOptions>();
  CLI::App* command = program.add_subcommand(
      "sweep", "Stiffness over depth, along a stress path, or for each row of a table: CSV and picture");
  add_sweep_options(*command, *options);
  group_sweep_options(*command);
  command->footer(rungs_help());
  return {command, [options] { return run(*options); }};
}

} // namespace granum::cli
