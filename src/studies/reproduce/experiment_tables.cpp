// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/reproduce/experiment_tables.hpp"

#include <utility>

#include <granum/core/version.hpp>
#include <granum/io/csv/columns.hpp>

namespace granum::studies {

namespace {

/// A table with a row for each item that `items_of` returns for a run; the first columns give the run.
template <class Item, class ItemsOf>
std::string csv_of(const Experiment& experiment, const io::Columns<Item>& columns, const ItemsOf& items_of) {
  struct Row {
    const ExperimentSpecimen* specimen;
    const PathRun* run;
    Item item;
  };
  io::Columns<Row> all = {{"contact", "", [](const Row& row) { return name(row.specimen->contact); }},
                          {"density", "", [](const Row& row) { return name(row.specimen->density); }},
                          {"seed", "", [](const Row& row) { return row.specimen->seed; }},
                          {"path", "", [](const Row& row) { return name(row.run->path); }}};
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

/// Whether the result of granum lies within the tolerance of the printed one.
const char* answer(Agreement agreement) {
  switch (agreement) {
  case Agreement::within:
    return "yes";
  case Agreement::beyond:
    return "no";
  case Agreement::undecided:
    return "undecided";
  default:
    return "";
  }
}

/// Null without a limit, or if undecided.
io::Value within(const CellRow& row) {
  const Agreement agreement = row.cell->agreement();
  if (agreement == Agreement::within || agreement == Agreement::beyond)
    return agreement == Agreement::within;
  return nullptr;
}

io::Value with_error(const CellRow& row) {
  const TableValue& ours = row.cell->ours;
  return ours.standard_error ? io::Value(Measured{ours.value, *ours.standard_error}) : io::Value(ours.value);
}

io::ShownColumn to_the_left(std::string heading, int width) {
  return {.heading = std::move(heading), .width = -width};
}
io::ShownColumn to_the_right(std::string heading, int width) {
  return {.heading = std::move(heading), .width = width};
}

io::Columns<StateRecord> frozen_state_columns() {
  io::Columns<StateRecord> columns;
  const auto add = [&](std::string heading, auto of) { columns.emplace_back(std::move(heading), "", of); };
  const auto closed = [&](std::string heading, auto of) {
    add(std::move(heading),
        [of](const StateRecord& p) { return p.closed ? std::optional(of(*p.closed)) : std::nullopt; });
  };
  const auto probed = [&](std::string heading, double Probes::*of) {
    add(std::move(heading),
        [of](const StateRecord& p) { return p.probes ? std::optional((*p.probes).*of) : std::nullopt; });
  };
  const auto matrix = [&](const std::string& prefix, std::array<double, 36> StateRecord::*of) {
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = i; j < 6; ++j)
        add(prefix + std::to_string(i + 1) + std::to_string(j + 1) + "_Pa",
            [=](const StateRecord& p) { return (p.*of)[6 * i + j]; });
  };
  add("eta", [](const StateRecord& p) { return p.at.stress.ratio(); });
  add("p_Pa", [](const StateRecord& p) { return p.at.stress.mean(); });
  add("s_v_Pa", [](const StateRecord& p) { return p.at.stress.v; });
  add("s_h_Pa", [](const StateRecord& p) { return p.at.stress.h; });
  add("axial_strain", [](const StateRecord& p) { return p.at.axial_strain; });
  add("volumetric_strain", [](const StateRecord& p) { return p.at.volumetric_strain; });
  add("frozen_s_v_Pa", [](const StateRecord& p) { return p.stress.v; });
  add("frozen_s_h_Pa", [](const StateRecord& p) { return p.stress.h; });
  add("e", &StateRecord::void_ratio);
  add("e_interior", &StateRecord::interior_void_ratio);
  add("C_n", [](const StateRecord& p) { return p.micro.coordination_number; });
  add("C_n_all_grains", &StateRecord::coordination_number_all);
  add("C_n_all_grains_error", &StateRecord::coordination_error);
  add("z_star", [](const StateRecord& p) { return p.micro.mechanical_coordination_number; });
  add("rattler_fraction", [](const StateRecord& p) { return p.micro.rattler_fraction; });
  add("a", [](const StateRecord& p) { return p.micro.fabric_anisotropy; });
  add("a_error", [](const StateRecord& p) { return p.micro.fabric_anisotropy_error; });
  add("sliding_fraction", [](const StateRecord& p) { return p.micro.sliding_fraction; });
  add("F11", [](const StateRecord& p) { return p.fabric(0, 0); });
  add("F22", [](const StateRecord& p) { return p.fabric(1, 1); });
  add("F33", [](const StateRecord& p) { return p.fabric(2, 2); });
  add("F23", [](const StateRecord& p) { return p.fabric(1, 2); });
  add("F13", [](const StateRecord& p) { return p.fabric(0, 2); });
  add("F12", [](const StateRecord& p) { return p.fabric(0, 1); });
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
  return columns;
}

} // namespace

std::string frozen_states_csv(const Experiment& experiment) {
  return csv_of(experiment, frozen_state_columns(), [](const PathRun& run) { return run.points; });
}

std::string curves_csv(const Experiment& experiment) {
  using Point = triaxial::PathPoint;
  return csv_of<Point>(experiment,
                       {{"eta", "", [](const Point& p) { return p.stress.ratio(); }},
                        {"p_Pa", "", [](const Point& p) { return p.stress.mean(); }},
                        {"s_v_Pa", "", [](const Point& p) { return p.stress.v; }},
                        {"s_h_Pa", "", [](const Point& p) { return p.stress.h; }},
                        {"axial_strain", "", &Point::axial_strain},
                        {"volumetric_strain", "", &Point::volumetric_strain},
                        {"work_J_per_m3", "", &Point::work},
                        {"step", "", &Point::step}},
                       [](const PathRun& run) { return run.curve; });
}

std::string loops_csv(const Experiment& experiment) {
  using Point = std::pair<double, triaxial::LoopPoint>; // with the eta of its loop
  return csv_of<Point>(experiment,
                       {{"eta", "", &Point::first},
                        {"shear_strain", "", [](const Point& p) { return p.second.shear_strain; }},
                        {"shear_stress_Pa", "", [](const Point& p) { return p.second.shear_stress; }}},
                       [](const PathRun& run) {
                         std::vector<Point> points;
                         for (const ShearLoop& loop : run.loops)
                           for (const triaxial::LoopPoint& point : loop.points)
                             points.emplace_back(loop.eta, point);
                         return points;
                       });
}

std::string histograms_csv(const Experiment& experiment) {
  struct Bin {
    triaxial::PathPoint at;
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
      add("polar angle [deg]", p.polar_counts, 90.0 / static_cast<double>(polar_bins));
      add("f_n/<f_n>", p.force_counts, 8.0 / static_cast<double>(force_bins));
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

std::vector<CellRow> cell_rows(const std::vector<TableRow>& rows) {
  std::vector<CellRow> out;
  for (const TableRow& row : rows)
    for (const Cell& cell : row.cells)
      out.push_back({&row, &cell});
  return out;
}

const io::Columns<CellRow>& cell_columns() {
  static const io::Columns<CellRow> columns = {
      {"contact", "contact", [](const CellRow& row) { return name(row.row->contact); },
       to_the_left("contact", 9)},
      {"density", "density", [](const CellRow& row) { return name(row.row->density); },
       to_the_left("density", 8)},
      {"quantity", "quantity", [](const CellRow& row) { return row.cell->quantity; },
       to_the_left("quantity", 28)},
      {"granum", "granum", [](const CellRow& row) { return row.cell->ours.value; }},
      {"", "", with_error, to_the_right("granum", 17)},
      {"standard_error", "standard_error",
       io::or_null([](const CellRow& row) { return row.cell->ours.standard_error; })},
      {"paper", "paper", io::or_null([](const CellRow& row) { return row.cell->printed; }),
       to_the_right("paper", 6)},
      {"difference", "",
       [](const CellRow& row) {
         return row.cell->printed ? std::optional(row.cell->ours.value - *row.cell->printed) : std::nullopt;
       }},
      {"reach", "reach", io::or_null([](const CellRow& row) { return row.cell->reach; })},
      {"within", "", [](const CellRow& row) { return answer(row.cell->agreement()); },
       to_the_right("within", 10)},
      {"", "within", within},
  };
  return columns;
}

std::string table_csv(const std::vector<TableRow>& rows) {
  return io::csv_text(cell_columns(), cell_rows(rows));
}

std::string table_text(const std::string& title, const std::vector<TableRow>& rows) {
  const std::vector<CellRow> cells = cell_rows(rows);
  return title + "\n" + (cells.empty() ? "  no measurements\n" : io::table_text(cell_columns(), cells));
}

} // namespace granum::studies
