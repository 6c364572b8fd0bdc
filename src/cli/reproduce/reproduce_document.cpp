// SPDX-License-Identifier: GPL-3.0-or-later
#include "reproduce_document.hpp"

#include "studies/verify/tables.hpp"
#include <fmt/format.h>
#include <granum/core/version.hpp>

#include "cli/options/scene_file.hpp"
#include "cli/verify/compression.hpp"
#include "cli/verify/verify_document.hpp"

namespace granum::cli {

namespace {

using studies::Agreement;
using studies::Cell;
using studies::ClosedForms;
using studies::Probes;
using triaxial::PathPoint;

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

// ---- files of rows

/// A file with a row for each item that `items_of` returns for a run.
template <class Item, class ItemsOf>
std::string csv_of(const Experiment& experiment, const io::Columns<Item>& columns, const ItemsOf& items_of) {
  struct Row {
    const ExperimentSpecimen* specimen;
    const PathRun* run;
    Item item;
  };
  io::Columns<Row> all = {
      {"contact", "", [](const Row& row) { return name(row.specimen->contact); }},
      {"density", "", [](const Row& row) { return studies::name(row.specimen->density); }},
      {"seed", "", [](const Row& row) { return row.specimen->seed; }},
      {"path", "", [](const Row& row) { return studies::name(row.run->path); }}};
  io::add_part(all, columns, [](const Row& row) { return &row.item; });
  std::vector<Row> rows;
  for (const ExperimentSpecimen& specimen : experiment.specimens)
    for (const PathRun& run : specimen.runs)
      for (const Item& item : items_of(run))
        rows.push_back({&specimen, &run, item});
  return io::csv_text(all, rows,
                      {{"program", "granum " + std::string(version()) + " reproduce"},
                       {"grains", std::to_string(experiment.scene.study.grains)},
                       {"boundary", experiment.scene.specimen.walls ? "six rigid walls" : "periodic"},
                       {"signs", "compression positive; z is the vertical axis v; eta = q/p' = "
                                 "(s_v - s_h)/p'; s_v, s_h: vertical and horizontal stress; p or p': their "
                                 "mean (s_v + 2 s_h)/3"}});
}

io::Columns<PathPoint> path_columns() {
  return {{"eta", "", [](const PathPoint& p) { return p.stress.ratio(); }},
          {"p_Pa", "", [](const PathPoint& p) { return p.stress.mean(); }},
          {"s_v_Pa", "", [](const PathPoint& p) { return p.stress.v; }},
          {"s_h_Pa", "", [](const PathPoint& p) { return p.stress.h; }},
          {"axial_strain", "", &PathPoint::axial_strain},
          {"volumetric_strain", "", &PathPoint::volumetric_strain}};
}

std::string states_csv(const Experiment& experiment) {
  io::Columns<StateRecord> columns;
  const auto add = [&](std::string heading, auto of) { columns.emplace_back(std::move(heading), "", of); };
  const auto closed = [&](const char* heading, auto of) {
    add(heading,
        [of](const StateRecord& p) { return p.closed ? std::optional(of(*p.closed)) : std::nullopt; });
  };
  const auto probed = [&](const char* heading, double Probes::*of) {
    add(heading,
        [of](const StateRecord& p) { return p.probes ? std::optional((*p.probes).*of) : std::nullopt; });
  };
  const auto micro = [&](const char* heading, double analysis::Microstructure::*of) {
    add(heading, [of](const StateRecord& p) { return p.micro.*of; });
  };
  const auto fabric = [&](const char* heading, int i, int j) {
    add(heading, [i, j](const StateRecord& p) { return p.fabric(i, j); });
  };
  const auto matrix = [&](const std::string& prefix, std::array<double, 36> StateRecord::*of) {
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = i; j < 6; ++j)
        add(fmt::format("{}{}{}_Pa", prefix, i + 1, j + 1),
            [=](const StateRecord& p) { return (p.*of)[6 * i + j]; });
  };
  io::add_part(columns, path_columns(), [](const StateRecord& p) { return &p.at; });
  add("frozen_s_v_Pa", [](const StateRecord& p) { return p.stress.v; });
  add("frozen_s_h_Pa", [](const StateRecord& p) { return p.stress.h; });
  add("e", &StateRecord::void_ratio);
  add("e_interior", &StateRecord::interior_void_ratio);
  micro("C_n", &analysis::Microstructure::coordination_number);
  add("C_n_all_grains", &StateRecord::coordination_number_all);
  add("C_n_all_grains_error", &StateRecord::coordination_error);
  micro("z_star", &analysis::Microstructure::mechanical_coordination_number);
  micro("rattler_fraction", &analysis::Microstructure::rattler_fraction);
  micro("a", &analysis::Microstructure::fabric_anisotropy);
  micro("a_error", &analysis::Microstructure::fabric_anisotropy_error);
  micro("sliding_fraction", &analysis::Microstructure::sliding_fraction);
  fabric("F11", 0, 0);
  fabric("F22", 1, 1);
  fabric("F33", 2, 2);
  fabric("F23", 1, 2);
  fabric("F13", 0, 2);
  fabric("F12", 0, 1);
  add("contacts", &StateRecord::contacts);
  add("G_hh_Pa", &StateRecord::G_hh);
  add("G_vh_Pa", &StateRecord::G_vh);
  closed("G_hh_uniform_strain_Pa", [](const ClosedForms& c) { return c.uniform_strain.G_hh(); });
  closed("G_vh_uniform_strain_Pa", [](const ClosedForms& c) { return c.uniform_strain.G_vh(); });
  closed("G_hh_uniform_stress_Pa", [](const ClosedForms& c) { return c.uniform_stress.G_hh(); });
  closed("G_vh_uniform_stress_Pa", [](const ClosedForms& c) { return c.uniform_stress.G_vh(); });
  closed("G_hh_relaxed_Pa", [](const ClosedForms& c) { return c.relaxed.G_hh(); });
  closed("G_hh_relaxed_error_Pa", [](const ClosedForms& c) { return c.G_hh_error * c.relaxed.G_hh(); });
  closed("G_vh_relaxed_Pa", [](const ClosedForms& c) { return c.relaxed.G_vh(); });
  closed("G_vh_relaxed_error_Pa", [](const ClosedForms& c) { return c.G_vh_error * c.relaxed.G_vh(); });
  probed("G_hh_probe_Pa", &Probes::G_hh);
  probed("G_hv_probe_Pa", &Probes::G_hv);
  probed("G_vh_probe_Pa", &Probes::G_vh);
  probed("probe_strain", &Probes::amplitude);
  add("unbalanced_force_ratio", &StateRecord::unbalanced_force_ratio);
  add("rest_steps", &StateRecord::rest_steps);
  matrix("network_C", &StateRecord::network);
  matrix("affine_C", &StateRecord::affine);
  return csv_of(experiment, columns, [](const PathRun& run) { return run.points; });
}

std::string curves_csv(const Experiment& experiment) {
  io::Columns<PathPoint> columns = path_columns();
  columns.push_back({"work_J_per_m3", "", &PathPoint::work});
  columns.push_back({"step", "", &PathPoint::step});
  return csv_of(experiment, columns, [](const PathRun& run) { return run.curve; });
}

std::string loops_csv(const Experiment& experiment) {
  using Point = std::pair<double, triaxial::LoopPoint>; // with the eta of its loop
  return csv_of<Point>(experiment,
                       {{"eta", "", &Point::first},
                        {"shear_strain", "", [](const Point& p) { return p.second.shear_strain; }},
                        {"shear_stress_Pa", "", [](const Point& p) { return p.second.shear_stress; }}},
                       [](const PathRun& run) {
                         std::vector<Point> points;
                         for (const studies::ShearLoop& loop : run.loops)
                           for (const triaxial::LoopPoint& point : loop.points)
                             points.emplace_back(loop.eta, point);
                         return points;
                       });
}

/// Contacts of every frozen state by direction and by force.
std::string histograms_csv(const Experiment& experiment) {
  struct Bin {
    PathPoint at;
    const char* of;
    double low, high;
    std::uint32_t contacts;
  };
  const auto bins = [](const PathRun& run) {
    std::vector<Bin> all;
    for (const StateRecord& p : run.points) {
      const auto add = [&](const char* of, const auto& counts, double width) {
        for (std::size_t k = 0; k < counts.size(); ++k) {
          const double low = static_cast<double>(k) * width;
          all.push_back({p.at, of, low, low + width, counts[k]});
        }
      };
      add("polar angle [deg]", p.polar_counts, 90.0 / static_cast<double>(studies::polar_bins));
      add("f_n/<f_n>", p.force_counts, 8.0 / static_cast<double>(studies::force_bins));
    }
    return all;
  };
  return csv_of<Bin>(experiment,
                     {{"eta", "", [](const Bin& bin) { return bin.at.stress.ratio(); }},
                      {"axial_strain", "", [](const Bin& bin) { return bin.at.axial_strain; }},
                      {"of", "", &Bin::of},
                      {"bin_low", "", &Bin::low},
                      {"bin_high", "", &Bin::high},
                      {"contacts", "", &Bin::contacts}},
                     bins);
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
    "that carry no load), a anisotropy of the contact directions (above zero: more near the vertical).",
    "Frozen states: a copy of the specimen is brought to rest with sliding prevented at all contacts. All "
    "measurements of a state are made on this copy.",
    "G of the network: linear response of the frozen contacts, every grain in equilibrium. Cyclic shear: a "
    "small shear strain back and forth on the frozen specimen, by the discrete element method (DEM). G_hh is "
    "the shear modulus of the horizontal plane, G_hv and G_vh that of a vertical plane.",
    "Uniform strain: G if every grain followed the mean strain; it exceeds G of the network. Relaxed closed "
    "form: the same times a reduction factor that depends on the number of contacts.",
    "Exponents: G = C p_a f(e) (s_i/p_a)^m (s_j/p_a)^n, the paper's Eq. (1), with f(e) = (2.17 - e)^2/(1 + "
    "e), p_a = 100 kPa and s = m + n. For G_hv s_i is the horizontal stress and s_j the vertical one; G_hh "
    "is fitted with the horizontal one alone. The paper's C is for p_a in MPa and is not compared.",
    "+- is one standard error: the larger of the scatter between seeds and the error of each seed, divided "
    "by the root of the number of seeds. With one seed, the scatter between specimens is not included. "
    "Within: whether the difference from the paper is within the limit (column reach of the CSV files); "
    "undecided if the standard error is larger than the limit.",
    "All numbers: states.csv, curves.csv, loops.csv, histograms.csv and the tables next to this page; the "
    "data of figures in the folder figures. Figures 1, 2 and 5 of the paper are sketches."};

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
               const char* file, const std::vector<Cell>& cells) {
  Table table = table_of_cells(key, title, cells);
  to.files.emplace_back(file, io::csv_text(table.columns, table.rows));
  table.remark = remark;
  table.folded = true;
  to.document.add(Seen::always, std::move(table));
}

} // namespace

Table table_of_cells(std::string key, std::string title, const std::vector<Cell>& cells) {
  const auto look = [](const char* heading, int width) {
    return io::ShownColumn{.heading = heading, .width = width};
  };
  const io::Columns<Cell> columns = {
      {"contact", "contact", [](const Cell& cell) { return name(cell.contact); }, look("contact", -9)},
      {"density", "density", [](const Cell& cell) { return studies::name(cell.density); },
       look("density", -8)},
      {"quantity", "quantity", &Cell::quantity, look("quantity", -28)},
      {"granum", "granum", [](const Cell& cell) { return cell.ours.value; }},
      {"", "",
       [](const Cell& cell) {
         const auto [value, error] = cell.ours;
         return error ? io::Value(Measured{value, *error}) : io::Value(value);
       },
       look("granum", 18)},
      {"standard_error", "standard_error",
       io::or_null([](const Cell& cell) { return cell.ours.standard_error; })},
      {"paper", "paper", io::or_null(&Cell::printed), look("paper", 6)},
      {"difference", "",
       [](const Cell& cell) {
         return cell.printed ? std::optional(cell.ours.value - *cell.printed) : std::nullopt;
       }},
      {"reach", "reach", io::or_null(&Cell::reach)},
      {"within", "",
       [](const Cell& cell) {
         constexpr const char* words[] = {"", "yes", "no", "undecided"}; // as Agreement
         return words[static_cast<std::size_t>(cell.agreement())];
       },
       look("within", 10)},
      {"", "within", [](const Cell& cell) { // null without a limit, or if undecided
         const Agreement agreement = cell.agreement();
         return agreement == Agreement::within   ? io::Value(true)
                : agreement == Agreement::beyond ? io::Value(false)
                                                 : io::Value(nullptr);
       }}};
  return table_of(std::move(key), std::move(title), columns, cells);
}

std::vector<Compression> compressions(const Experiment& experiment) {
  const std::vector<Cell> exponents = table_5(experiment);
  std::vector<Compression> out;
  for (const Kind& kind : kinds(experiment)) {
    Compression one{.contact = kind.contact,
                    .density = kind.density,
                    .contact_exponent = contact_exponent(experiment.scene, kind.contact)};
    for (const Cell& cell : exponents)
      if (cell.contact == kind.contact && cell.density == kind.density && cell.quantity == "s of G_hv")
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
  ExperimentDocument out{.document = {.command = "reproduce"},
                         .files = {{"states.csv", states_csv(experiment)},
                                   {"curves.csv", curves_csv(experiment)},
                                   {"loops.csv", loops_csv(experiment)},
                                   {"histograms.csv", histograms_csv(experiment)}},
                         .panels = {}};
  Document& to = out.document;
  const std::size_t specimens = experiment.specimens.size();
  to.title = fmt::format(
      "The experiment of Chung et al. 2014: {} specimen{} of {} grains, {} frozen states in "
      "{:.1f} s on {}{}{}",
      specimens, specimens == 1 ? "" : "s", experiment.scene.study.grains, frozen_states(experiment),
      time.seconds, threads_text(studies::thread_count(experiment.scene)),
      time.resumed ? ", since it was resumed" : "",
      experiment.complete() ? "" : "; not complete, some ended early");
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
  to.add(Seen::full, scene_items(experiment.scene));
  to.add(Seen::full, left_out(experiment));
  add_cost_of_sizes(to, experiment.scene);
  to.add_notes(std::vector<std::string>(std::begin(how_to_read), std::end(how_to_read)));
  return out;
}

} // namespace granum::cli
