// SPDX-License-Identifier: GPL-3.0-or-later
#include "depth.hpp"

#include <algorithm>
#include <memory>

#include <fmt/core.h>
#include <granum/core/error.hpp>

#include "cli/options/densest_packing.hpp"
#include "curves.hpp"

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

/// A number that is recorded as given.
Value points_value(SweepOptions& o) {
  Value value = whole_number(o.points, 2, 1000000);
  value.take = [&o, take = value.take](const std::string& name, const std::string& text) {
    take(name, text);
    o.points_given = true;
  };
  return value;
}

/// A strain, or the first and the last of a curve.
OptionRow strain_row(SweepOptions& o) {
  OptionRow row = input_option(o.inputs, Input::shear_strain);
  row.meaning += "; with --for a range of them, 0.0001%..1%";
  row.value.joins_units = true;
  row.value.take = [&o, one = row.value.take](const std::string& name, const std::string& text) {
    const auto ends = ends_of_range(text);
    if (!ends)
      return one(name, text);
    for (const std::string& end : *ends) {
      one(name, end);
      o.strains.push_back(o.inputs.within(Input::shear_strain));
    }
    if (!(o.strains[0] < o.strains[1]))
      throw InvalidArgument(fmt::format("{} = '{}' must be the smaller strain, then the larger", name, text));
  };
  return row;
}

void add_curve_options(Command& command, SweepOptions& o) {
  command.add(strain_row(o));
  Value form =
      choice({"table", "pystrata", "strata"}, [&o](const std::string& word) { o.curves_for = word; });
  command.add(
      "Curves over strain",
      {{.name = "--for",
        .value = std::move(form),
        .meaning = "Curves of G/G0 and damping over --strain FROM..TO, for one state or each depth or "
                   "row, in the form of a program of site response: a table, TOML of pystrata, or JSON "
                   "of Strata. 13 strains unless --points gives another number for one state",
        .excludes = {{"--path --from --to --eta --friction-angle --spacing --rungs --laws --columns "
                      "--picture-of --densest"}},
        .needs = {{"--strain", "--strain FROM..TO, the strains of its curves"}},
        .synonyms = {{"curve curves siteresponse deepsoil"}}}});
}

/// What makes a sweep of the options that follow.
void add_ways(Command& command, SweepOptions& o) {
  Value depth = text(o.ground.depth, "FROM..TO");
  depth.joins_units = true;
  command.add(
      "What to sweep",
      {{.name = "--depth",
        .value = std::move(depth),
        .meaning =
            "Stiffness over depth in level ground, between two depths: 0m..30m; with V_s30, the travel "
            "time of a shear wave and the period 4 H/V_s",
        .excludes = {{"--path --from --to --eta --friction-angle --spacing --table --rungs --picture-of"}},
        .synonyms = {{"z"}}},
       {.name = "--path",
        .value = choice({"iso", "txc", "rtxc", "rtxe", "txe"}, o.path),
        .meaning = "Stress path. iso: equal stresses, from --from to --to. The others, from --from to --eta: "
                   "txc, vertical stress grows; rtxc, horizontal stress falls; rtxe, vertical stress falls; "
                   "txe, horizontal stress grows"},
       {.name = "--table",
        .value = path(o.table, "FILE.csv"),
        .meaning = "States from the rows of this CSV file",
        .excludes = {{"--path --from --to --eta --friction-angle --points --spacing --picture-of"}},
        .synonyms = {{"csv file input data"}}}});
}

void add_path_options(Command& command, SweepOptions& o) {
  const std::vector<Belonging> sheared = {
      {"--path", "txc rtxc rtxe txe", "iso", "--path txc, rtxc, rtxe and txe, not with iso"}};
  command.add(
      "Path",
      {{.name = "--from",
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
        .value = points_value(o),
        .meaning = "States on the path, or depths, or strains of one curve, both ends included"}});
}

void add_ground_options(Command& command, GroundOptions& o) {
  command.add(
      ground_group,
      {{.name = "--layers",
        .value = path(o.layers, "FILE.csv"),
        .meaning =
            "Layers of the ground, one per row from its top_m down, with columns as for --table: e or D_r, "
            "unit_weight, saturated_unit_weight, k0, sand, S_r",
        .needs = {{"--depth", "--depth"}},
        .synonyms = {{"profile soil strata"}}}});
  add_ground(command, o, {{"--depth --table", "--depth"}});
  command.add(ground_group, {{.name = "--k0",
                              .value = number(o.earth_pressure_at_rest),
                              .meaning = "K_0, horizontal over vertical effective stress in the ground",
                              .needs = {{"--depth --table --for", "--depth"}},
                              .synonyms = {{"k0 ko"}}}});
}

void add_table_options(Command& command, SweepOptions& o) {
  Value rungs = choice(names_of(effective::closed_forms(), &Rung::key),
                       [&o](const std::string& key) { o.rungs.push_back(key); });
  rungs.by_default = "all; none in the CSV of a table";
  rungs.several = true;
  rungs.delimiter = ',';
  Value columns = choice({"usual", "all"}, [&o](const std::string& text) { o.all_columns = text == "all"; });
  columns.by_default = "usual";
  Value units = choice({"practice", "si"}, [&o](const std::string& text) { o.si = text == "si"; });
  units.by_default = "practice";
  command.add(
      "Table and columns",
      {{.name = "--rungs",
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
                   "speeds, and every rung for a table"},
       {.name = "--units",
        .value = std::move(units),
        .meaning = "Units of the CSV. practice: kPa for stresses, MPa for moduli, five digits; si: exact SI",
        .excludes = {{"--for"}}}});
}

/// Stresses are options for a table only: a path and the ground determine theirs.
void restrict_stresses(Command& command) {
  for (const char* stress : {"--pressure", "--stress-v", "--stress-h"})
    command.row(stress).needs = {
        {"--table", "--table; with --depth the stress follows from the weight of the ground", "--depth"},
        {"--table --depth --for", "--table or --for; the stress of a path begins at --from"}};
}

void add_sweep_options(Command& command, SweepOptions& o) {
  add_ways(command, o);
  add_packing_options(command, o.inputs);
  add_answer_options(command, o.inputs);
  add_curve_options(command, o);
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
  if (o.strains.empty() != o.curves_for.empty())
    throw InvalidArgument(o.strains.empty()
                              ? "--for goes with a range of strains, --strain 0.0001%..1%"
                              : "--strain FROM..TO is a curve: give --for table, pystrata or strata");
  if (!o.table.empty() && !o.strains.empty())
    return sweep_curves(o);
  if (!o.table.empty())
    return sweep_table(o, chosen_rungs(o));
  if (o.ground.layers.empty()) // layers set their own K_0
    o.inputs = estimate::completed(std::move(o.inputs));
  if (!o.densest.empty())
    make_densest(o.inputs);
  if (!o.strains.empty())
    return sweep_curves(o);
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
