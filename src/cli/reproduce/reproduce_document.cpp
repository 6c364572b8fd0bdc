// SPDX-License-Identifier: GPL-3.0-or-later
#include "reproduce_document.hpp"

#include <numbers>

#include "studies/plan/plan.hpp"
#include "studies/verify/tables.hpp"
#include <fmt/format.h>
#include <granum/core/number.hpp>

#include "cli/options/scene_file.hpp"
#include "cli/verify/compression.hpp"
#include "cli/verify/verify_document.hpp"

namespace granum::cli {

namespace {

using studies::Agreement;
using studies::Cell;
using studies::TableRow;

std::string where(const ExperimentSpecimen& specimen, const PathRun& run) {
  return fmt::format("{}, {}, seed {}, {}", name(specimen.contact), studies::name(specimen.density),
                     specimen.seed, studies::name(run.path));
}

std::size_t frozen_states(const Experiment& experiment) {
  std::size_t count = 0;
  for (const ExperimentSpecimen& specimen : experiment.specimens)
    for (const PathRun& run : specimen.runs)
      count += run.points.size();
  return count;
}

// ---- sections

/// A state of isotropic compression as the first pictures show it.
RouteState route_state(const StateRecord& point) {
  RouteState out{.pressure = point.at.stress.mean(),
                 .mechanical_coordination_number = point.micro.mechanical_coordination_number,
                 .network = {point.G_vh(), point.G_vh(), point.G_hh()},
                 .softening = network_over_uniform_strain(point)};
  if (point.closed)
    out.relaxed = {point.closed->relaxed.G_vh(), point.closed->relaxed.G_vh(), point.closed->relaxed.G_hh()};
  if (point.probes)
    out.probe = {point.probes->G_hv, point.probes->G_vh, point.probes->G_hh};
  return out;
}

void add_facts(Document& to, const Experiment& experiment, const RunTime& time) {
  Items facts;
  io::add_item(facts.items, "wall_time_s", time.seconds);
  io::add_item(facts.items, "resumed", time.resumed);
  io::add_item(facts.items, "complete", experiment.complete());
  to.add(Seen::data, std::move(facts));
  to.add(Seen::data, Data{"scene", json_of(experiment.scene)});
  to.add(Seen::data, Data{"threads_used", studies::thread_count(experiment.scene)});
  to.add(Seen::data,
         Data{"conventions",
              {{"units", "SI, as in the names; friction angles in degrees"},
               {"signs", "compression positive; z is vertical; eta = q/p' = (s_v - s_h)/p', s_v and s_h the "
                         "vertical and the horizontal stress; strains are logarithmic"},
               {"G", "of the contact network of the frozen state, without sliding in any contact; probes by "
                     "cyclic shear"}}});
}

/// "25, 50, 100".
template <class Numbers, class Text>
std::string listed(const Numbers& numbers, const Text& text) {
  std::string out;
  for (const auto& number : numbers)
    out += (out.empty() ? "" : ", ") + std::string(text(number));
  return out;
}

/// What was run, in words.
Items run_items(const Experiment& experiment, const RunTime& time) {
  const studies::Scene& scene = experiment.scene;
  const studies::StudySection& study = scene.study;
  Items out{.title = "what was run"};
  const auto add = [&out](const char* what, const std::string& text) {
    io::add_item(out.items, "", text, shown_as(what));
  };
  add("specimens", fmt::format("{} of {} grains: {}; {}; {}", experiment.specimens.size(), study.grains,
                               listed(study.contacts, [](contact::Shape s) { return name(s); }),
                               listed(study.densities, [](triaxial::Density d) { return studies::name(d); }),
                               study.seeds == 1 ? fmt::format("seed {}", study.first_seed)
                                                : fmt::format("seeds {} to {}", study.first_seed,
                                                              study.first_seed + study.seeds - 1)));
  add("boundary", scene.specimen.walls
                      ? "six rigid walls, friction " + short_text(scene.specimen.wall_friction)
                      : std::string("periodic cell"));
  add("grains", fmt::format("diameter {} mm, shear modulus {} GPa, Poisson's ratio {}, friction angle {} deg",
                            short_text(2e3 * scene.grain.radius), short_text(scene.grain.shear_modulus / 1e9),
                            short_text(scene.grain.poisson_ratio),
                            short_text(scene.grain.friction_angle * 180 / std::numbers::pi)));
  add("isotropic compression",
      listed(study.pressures, [](double pascal) { return short_text(pascal / 1e3); }) + " kPa");
  add("paths",
      fmt::format("{} to an axial strain of {} %, inertial number {}",
                  listed(scene.shear.paths, [](stress::ShearPath p) { return stress::name(p); }),
                  short_text(100 * scene.shear.largest_strain), short_text(scene.shear.inertial_number)));
  add("frozen states",
      fmt::format("{}, every {} of eta and every {} % of axial strain", frozen_states(experiment),
                  short_text(scene.shear.eta_step), short_text(100 * scene.shear.strain_step)));
  add("wall time",
      (time.seconds < 120 ? short_text(time.seconds, 3) + " s" : short_text(time.seconds / 60, 3) + " min") +
          (time.resumed ? ", since it was resumed" : ""));
  add("complete", experiment.complete() ? "yes" : "no, see what was left out");
  return out;
}

Prose left_out(const Experiment& experiment) {
  Prose out;
  for (const ExperimentSpecimen& specimen : experiment.specimens)
    for (const PathRun& run : specimen.runs) {
      if (!run.failure.empty())
        out.lines.push_back(where(specimen, run) + ": ended early: " + run.failure);
      for (const std::string& note : run.notes)
        out.lines.push_back(where(specimen, run) + ": " + note);
    }
  if (out.lines.empty())
    out.lines.emplace_back("left out: nothing; every path ran to its end, and every state could be frozen");
  return out;
}

/// The runs in numbers, for files.
Table run_table(const Experiment& experiment) {
  using Row = std::pair<const ExperimentSpecimen*, const PathRun*>;
  io::Columns<Row> columns = {
      {"", "contact", [](const Row& row) { return name(row.first->contact); }},
      {"", "density", [](const Row& row) { return studies::name(row.first->density); }},
      {"", "seed", [](const Row& row) { return row.first->seed; }},
      {"", "path", [](const Row& row) { return studies::name(row.second->path); }},
      {"", "frozen_states", [](const Row& row) { return row.second->points.size(); }},
      {"", "steps", [](const Row& row) { return row.second->steps; }},
      {"", "peak_eta", [](const Row& row) { return row.second->peak.stress.ratio(); }},
      {"", "path_error", [](const Row& row) { return row.second->path_error; }},
      {"", "largest_inertial_number", [](const Row& row) { return row.second->largest_inertial_number; }},
      {"", "notes", [](const Row& row) { return row.second->notes; }},
      {"", "failure", [](const Row& row) { return row.second->failure; }}};
  std::vector<Row> rows;
  for (const ExperimentSpecimen& specimen : experiment.specimens)
    for (const PathRun& run : specimen.runs)
      rows.emplace_back(&specimen, &run);
  return table_of("runs", "", columns, rows);
}

constexpr const char* how_to_read[] = {
    "The experiment is that of [Chung2014].",
    "Signs: compression is positive, of stress and of strain. v is the vertical axis z, h are the horizontal "
    "axes. eta = q/p' with q = sigma_v - sigma_h and p' = (sigma_v + 2 sigma_h)/3: above zero in compression "
    "(TXC, RTXC), below zero in extension (RTXE, TXE). Strains are logarithmic, from the start of each path.",
    "Symbols: e void ratio, C_n mean number of contacts of a grain, z* the same without rattlers (grains "
    "that "
    "carry no load), a anisotropy of the contact directions (above zero: more near the vertical).",
    "Frozen states: a copy of the specimen is brought to rest with sliding prevented at all contacts. All "
    "measurements of a state are made on this copy.",
    "G of the network: linear response of the frozen contacts, every grain in equilibrium. Cyclic shear: a "
    "small shear strain back and forth on the frozen specimen, by the discrete element method (DEM). G_hh is "
    "the shear modulus of the horizontal plane, G_hv and G_vh that of a vertical plane.",
    "Uniform strain: G if every grain followed the mean strain; it exceeds G of the network. Relaxed closed "
    "form: the same times a reduction factor that depends on the number of contacts.",
    "Exponents: G = C p_a f(e) (s_i/p_a)^m (s_j/p_a)^n, the paper's Eq. (1), with f(e) = (2.17 - e)^2/(1 + "
    "e), "
    "p_a = 100 kPa and s = m + n. For G_hv s_i is the horizontal stress and s_j the vertical one; G_hh is "
    "fitted with the horizontal one alone. The paper's C is for p_a in MPa and is not compared.",
    "+- is one standard error: the larger of the scatter between seeds and the error of each seed, divided "
    "by "
    "the root of the number of seeds. With one seed, the scatter between specimens is not included. Within: "
    "whether the difference from the paper is within the limit (column reach of the CSV files); undecided if "
    "the standard error is larger than the limit.",
    "All numbers: states.csv, curves.csv, loops.csv, histograms.csv and the tables next to this page; the "
    "data "
    "of figures in the folder figures. Figures 1, 2 and 5 of the paper are sketches."};

/// Fig. 3 and the others, folded.
void add_figures(ExperimentDocument& to, const Experiment& experiment) {
  if (const std::optional<AssemblyPicture> assembly = assembly_picture(experiment)) {
    to.document.add(Seen::full, Picture{.charts = {},
                                        .caption = assembly->drawing.finding,
                                        .drawn = plot::svg_in_page(assembly->drawing),
                                        .folded = "Fig. 3: the assembly of particles"});
    to.files.emplace_back(fmt::format("{}/{}.svg", figures_name, assembly->stem),
                          plot::svg(assembly->drawing));
  }
  for (const Figure& figure : experiment_figures(experiment)) {
    Picture picture = picture_of(figure.panels, figure.caption);
    picture.folded = figure.name + ": " + figure.title;
    to.document.add(Seen::full, std::move(picture));
    to.panels.insert(to.panels.end(), figure.panels.begin(), figure.panels.end());
  }
}

/// A table beside the paper's, and its file.
void add_cells(ExperimentDocument& to, const char* key, const char* title, const char* remark,
               const char* file, const std::vector<TableRow>& rows) {
  Table table = table_of_cells(key, title, rows);
  to.files.emplace_back(file, io::csv_text(table.columns, table.rows));
  table.remark = remark;
  table.folded = true;
  to.document.add(Seen::always, std::move(table));
}

} // namespace

Table table_of_cells(std::string key, std::string title, const std::vector<TableRow>& rows) {
  using Row = std::pair<const TableRow*, const Cell*>;
  const auto look = [](const char* heading, int width) {
    return io::ShownColumn{.heading = heading, .width = width};
  };
  const io::Columns<Row> columns = {
      {"contact", "contact", [](const Row& row) { return name(row.first->contact); }, look("contact", -9)},
      {"density", "density", [](const Row& row) { return studies::name(row.first->density); },
       look("density", -8)},
      {"quantity", "quantity", [](const Row& row) { return row.second->quantity; }, look("quantity", -28)},
      {"granum", "granum", [](const Row& row) { return row.second->ours.value; }},
      {"", "",
       [](const Row& row) {
         const studies::TableValue& ours = row.second->ours;
         return ours.standard_error ? io::Value(Measured{ours.value, *ours.standard_error})
                                    : io::Value(ours.value);
       },
       look("granum", 18)},
      {"standard_error", "standard_error",
       io::or_null([](const Row& row) { return row.second->ours.standard_error; })},
      {"paper", "paper", io::or_null([](const Row& row) { return row.second->printed; }), look("paper", 6)},
      {"difference", "",
       [](const Row& row) {
         return row.second->printed ? std::optional(row.second->ours.value - *row.second->printed)
                                    : std::nullopt;
       }},
      {"reach", "reach", io::or_null([](const Row& row) { return row.second->reach; })},
      {"within", "",
       [](const Row& row) {
         constexpr const char* words[] = {"", "yes", "no", "undecided"}; // as Agreement
         return words[static_cast<std::size_t>(row.second->agreement())];
       },
       look("within", 10)},
      {"", "within", [](const Row& row) { // null without a limit, or if undecided
         const Agreement agreement = row.second->agreement();
         return agreement == Agreement::within   ? io::Value(true)
                : agreement == Agreement::beyond ? io::Value(false)
                                                 : io::Value(nullptr);
       }}};
  std::vector<Row> cells;
  for (const TableRow& row : rows)
    for (const Cell& cell : row.cells)
      cells.emplace_back(&row, &cell);
  return table_of(std::move(key), std::move(title), columns, cells);
}

std::vector<Compression> compressions(const Experiment& experiment) {
  const std::vector<TableRow> exponents = table_5(experiment);
  std::vector<Compression> out;
  for (const Kind& kind : kinds(experiment)) {
    Compression one{.contact = kind.contact,
                    .density = kind.density,
                    .contact_exponent = contact_exponent(experiment.scene, kind.contact)};
    for (const TableRow& row : exponents)
      for (const Cell& cell : row.cells)
        if (row.contact == kind.contact && row.density == kind.density && cell.quantity == "s of G_hv")
          one.exponent = Measured{cell.ours.value, cell.ours.standard_error.value_or(0)};
    if (const PathRun* run = find_run(*kind.specimen, std::nullopt))
      for (const StateRecord& point : run->points)
        one.states.push_back(route_state(point));
    out.push_back(std::move(one));
  }
  return out;
}

ExperimentDocument experiment_document(const Experiment& experiment,
                                       const std::vector<studies::Verdict>& verdicts, const RunTime& time) {
  ExperimentDocument out{.document = {.command = "reproduce"}, .files = row_files(experiment), .panels = {}};
  Document& to = out.document;
  const std::size_t specimens = experiment.specimens.size();
  to.title = fmt::format(
      "The experiment of Chung et al. 2014: {} specimen{} of {} grains, {} frozen states in "
      "{:.1f} s on {}",
      specimens, specimens == 1 ? "" : "s", experiment.scene.study.grains, frozen_states(experiment),
      time.seconds, threads_text(studies::thread_count(experiment.scene)));
  out.panels = add_compression(to, experiment.scene, compressions(experiment));
  add_figures(out, experiment);
  add_facts(to, experiment, time);
  to.add(Seen::first,
         Prose{{"granum: result of this run +- its standard error, where it is known; paper: Chung "
                "et al. 2014; within: whether the difference is within the tolerance, undecided "
                "if the standard error exceeds the tolerance"}});
  add_cells(out, "table_2", "Table 2: start of isotropic compression",
            "C_n: contacts per grain, e: void ratio", "table2.csv", table_2(experiment));
  add_cells(out, "table_4", "Table 4: friction angle at the peak of q/p', by stress path", "", "table4.csv",
            table_4(experiment));
  add_cells(out, "table_5", "Table 5: exponents and C of the networks' moduli at |q/p'| up to 0.6",
            "G_hv = C p_a f(e) (sigma_h/p_a)^m (sigma_v/p_a)^n, s = m + n, and G_hh with sigma_h alone",
            "table5.csv", table_5(experiment));
  add_cells(out, "further_exponents", "Further exponents", "", "exponents.csv",
            further_exponents(experiment));
  to.add(Seen::always, verdict_table(verdicts));
  out.files.emplace_back("verdicts.csv", io::csv_text(studies::verdict_columns(), verdicts));
  to.add(Seen::data, run_table(experiment));
  to.add(Seen::full, run_items(experiment, time));
  to.add(Seen::full, left_out(experiment));
  if (const std::string cost = studies::cost_of_sizes(experiment.scene); !cost.empty())
    to.notes.push_back({cost});
  to.add_notes({std::begin(how_to_read), std::end(how_to_read)});
  return out;
}

} // namespace granum::cli
