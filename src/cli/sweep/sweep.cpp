// SPDX-License-Identifier: GPL-3.0-or-later
#include "depth.hpp"

#include <algorithm>
#include <memory>

#include <fmt/core.h>
#include <granum/core/error.hpp>

#include "cli/options/densest_packing.hpp"

namespace granum::cli {

namespace {

using effective::Rung;

/// The requested rungs, or all of them.
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
  return text + "Columns of a table have the names of the options, with their unit:\n"
                "void_ratio, stress_v_kPa, \"stress v (kPa)\"; or symbols: e, p_kPa,\n"
                "sigma_v [kPa], C_n, z_star, a, C_u, D_r. Text columns are contact, sizes,\n"
                "preparation, grain, sand. With semicolons between columns, decimal commas\n"
                "are allowed.";
}

template <class Item>
std::vector<std::string> names_of(std::span<const Item> items, const char* Item::*member) {
  std::vector<std::string> names;
  for (const Item& item : items)
    names.emplace_back(item.*member);
  return names;
}

void add_path_options(Command& command, SweepOptions& o) {
  const std::vector<Belonging> sheared = {
      {"--path", "txc rtxc rtxe txe", "iso", "--path txc, rtxc, rtxe and txe, not with iso"}};
  command.add(
      "Path",
      {{.name = "--path",
        .value = choice({"iso", "txc", "rtxc", "rtxe", "txe"}, o.path),
        .meaning = "Stress path. iso: equal stresses, from --from to --to. The others, from --from to --eta: "
                   "txc, vertical stress grows; rtxc, horizontal stress falls; rtxe, vertical stress falls; "
                   "txe, horizontal stress grows"},
       {.name = "--from",
        .value = number_without_default(o.from),
        .meaning = "Mean stress at the start",
        .synonyms = command.row("--pressure").synonyms},
       {.name = "--to",
        .value = number_without_default(o.to),
        .meaning = "Mean stress at the end of --path iso",
        .belongs = {{"--path", "iso", "iso", "--path iso; other paths end at --eta or --friction-angle"}}},
       {.name = "--eta",
        .value = number_without_default(o.eta),
        .meaning = "Stress ratio q/p' = (sigma_v - sigma_h)/p' at the end of the other paths; negative for "
                   "rtxe and txe",
        .excludes = {{"--friction-angle", "give one of --eta and --friction-angle: the end of the path"}},
        .belongs = sheared,
        .synonyms = {{"stressratio q"}}},
       {.name = "--friction-angle",
        .value = number_without_default(o.friction_angle),
        .meaning = "End at failure with this friction angle, instead of --eta",
        .belongs = sheared,
        .synonyms = {{"phi mu friction frictioncoefficient"}}},
       {.name = "--spacing",
        .value = choice({"log", "linear"}, o.spacing),
        .meaning = "Spacing of the states in p' or eta; by default log for iso, linear for others"},
       {.name = "--points",
        .value = whole_number(o.points, 2, 1000000),
        .meaning = "States on the path, or depths, both ends included"}});
}

void add_table_options(Command& command, SweepOptions& o) {
  Value rungs = choice(names_of(effective::closed_forms(), &Rung::key),
                       [&o](const std::string& key) { o.rungs.push_back(key); });
  rungs.by_default = "all; none in the CSV of a table";
  rungs.several = true;
  rungs.delimiter = ',';
  Value columns = choice({"usual", "all"}, [&o](const std::string& text) { o.all_columns = text == "all"; });
  columns.by_default = "usual";
  command.add(
      "Table and columns",
      {{.name = "--table",
        .value = path(o.table, "FILE.csv"),
        .meaning = "States from the rows of this CSV file",
        .excludes = {{"--path --from --to --eta --friction-angle --points --spacing --picture-of"}},
        .synonyms = {{"csv file input data"}}},
       {.name = "--rungs",
        .value = std::move(rungs),
        .meaning = "Closed forms to compare with (rungs, below), separated by commas"},
       {.name = "--laws",
        .value = flag(o.law_columns),
        .meaning =
            "Also published laws of sands: one column each, and their range in the picture of G along a "
            "path or over depth"},
       {.name = "--columns",
        .value = std::move(columns),
        .meaning = "Columns of the CSV. usual: G, V_s, V_p, z* and s of the answer with their ranges, and G "
                   "at a strain if one is given; all: "
                   "all moduli and "
                   "speeds, and every rung for a table"}});
}

/// Stresses are options for a table only: a path and the ground determine theirs.
void restrict_stresses(Command& command) {
  for (const char* stress : {"--pressure", "--stress-v", "--stress-h"})
    command.row(stress).needs = {
        {"--table", "--table; with --depth the stress follows from the weight of the ground", "--depth"},
        {"--table --depth", "--table; the stress of a path begins at --from"}};
}

void add_sweep_options(Command& command, SweepOptions& o) {
  add_packing_options(command, o.inputs);
  add_answer_options(command, o.inputs);
  command.add(input_option(o.inputs, Input::shear_strain));
  OptionRow densest = densest_row(o.densest);
  densest.excludes.push_back({"--table --layers", "--densest made is for one kind of grains: give a column "
                                                  "least_void_ratio with the void ratio of each"});
  command.add(contacts_group, {std::move(densest)});
  add_path_options(command, o);
  add_ground_options(command, o.ground);
  add_table_options(command, o);
  restrict_stresses(command);
  add_output_options(command, o.output);
  add_picture(
      command, o.picture,
      "Draw the answer with its range and the rungs along the path; stresses and answers over depth; or "
      "G of a table's rows");
  command.row("--picture").excludes = {{"--json"}};
  add_report(command, o.report);
  command.add(output_group,
              {{.name = "--picture-of",
                .value = choice(names_of(swept_quantities(), &SweptQuantity::name), o.picture_of),
                .meaning = "Quantity in the picture of a path; by default G_hv",
                .needs = {{"--picture --report", "--picture or --report"}}}});
}

ExitCode run(SweepOptions o) {
  const bool by_path = o.table.empty() && o.ground.depth.empty();
  o.inputs.ground = !o.ground.depth.empty();
  if (!o.table.empty())
    return sweep_table(o, chosen_rungs(o));
  if (o.ground.layers.empty()) // layers set their own K_0
    o.inputs = estimate::completed(std::move(o.inputs));
  if (!o.densest.empty())
    make_densest(o.inputs);
  return by_path ? sweep_path(o, chosen_rungs(o)) : sweep_depth(o);
}

} // namespace

Command make_sweep() {
  auto options = std::make_shared<SweepOptions>();
  Command command{.name = "sweep",
                  .meaning = "Stiffness over depth, along a stress path, or for each row of a table: CSV and "
                             "picture",
                  .notes = rungs_help(),
                  .run = [options] { return run(*options); }};
  add_sweep_options(command, *options);
  return command;
}

} // namespace granum::cli
