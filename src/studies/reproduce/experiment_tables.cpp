// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/reproduce/experiment_tables.hpp"

#include <utility>

#include <granum/core/number.hpp>
#include <granum/core/version.hpp>
#include <granum/io/csv/columns.hpp>
#include <granum/io/csv/table.hpp>

namespace granum::studies {

namespace {

std::string words(std::string_view view) { return std::string(view); }

/// Number of cells of one row that belong together, or their headings.
using Cells = std::vector<io::CsvCell>;

io::CsvContent headed(const Experiment& experiment, std::vector<std::string> headings) {
  io::CsvContent csv;
  csv.notes = {{"program", "granum " + words(version()) + " reproduce"},
               {"grains", std::to_string(experiment.scene.study.grains)},
               {"boundary", experiment.scene.specimen.walls ? "six rigid walls" : "periodic"},
               {"signs", "compression positive; z is the vertical axis v; eta = (s_v - s_h)/p'"}};
  csv.headings = {"contact", "density", "seed", "path"};
  csv.headings.insert(csv.headings.end(), headings.begin(), headings.end());
  return csv;
}

Cells place(const ExperimentSpecimen& specimen, const PathRun& run) {
  return {words(name(specimen.contact)), words(name(specimen.density)), static_cast<double>(specimen.seed),
          words(name(run.path))};
}

void append(Cells& cells, std::initializer_list<double> numbers) {
  cells.insert(cells.end(), numbers.begin(), numbers.end());
}

/// Rows of a CSV file, one for each `item` of each run.
template <class Items, class Row>
std::string rows_of(const Experiment& experiment, io::CsvContent csv, Items items, const Row& row) {
  for (const ExperimentSpecimen& specimen : experiment.specimens)
    for (const PathRun& run : specimen.runs)
      for (const auto& item : run.*items)
        row(csv, place(specimen, run), item);
  return io::csv_text(csv);
}

/// The same with one row an item, by columns.
template <class Item>
std::string csv_of(const Experiment& experiment, std::vector<Item> PathRun::*items,
                   const io::Columns<Item>& columns) {
  io::CsvContent csv = headed(experiment, {});
  io::add_headings(csv, columns);
  return rows_of(experiment, std::move(csv), items,
                 [&columns](io::CsvContent& to, Cells cells, const Item& item) {
                   io::add_cells(cells, columns, item);
                   to.rows.push_back(std::move(cells));
                 });
}

std::string number(double value, int digits) { return detail::formatted("%.*f", digits, value); }

/// Digits behind the point that a quantity of this size is shown with.
int digits_of(double value) { return value >= 10 ? 1 : 3; }

std::string shown(const Cell& cell) {
  const int digits = digits_of(cell.ours.value);
  std::string text = number(cell.ours.value, digits);
  if (cell.ours.standard_error)
    text += " +- " + number(*cell.ours.standard_error, digits);
  if (cell.printed)
    text += " (" + number(*cell.printed, digits_of(*cell.printed)) + ")";
  switch (cell.agreement()) {
  case Agreement::beyond:
    return text + " !";
  case Agreement::undecided:
    return text + " ?";
  default:
    return text;
  }
}

/// To "is ours within reach?".
const char* answer(Agreement agreement) {
  switch (agreement) {
  case Agreement::within:
    return "yes";
  case Agreement::beyond:
    return "no";
  case Agreement::undecided:
    return "cannot tell";
  default:
    return "";
  }
}

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(width, text.size()), ' ');
  return text;
}

io::Columns<StateRecord> frozen_state_columns() {
  io::Columns<StateRecord> columns;
  const auto add = [&](std::string heading, std::function<std::optional<double>(const StateRecord&)> of) {
    columns.emplace_back(std::move(heading), "", std::move(of));
  };
  const auto closed = [&](std::string heading, double (*of)(const ClosedForms&)) {
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
  add("e", [](const StateRecord& p) { return p.void_ratio; });
  add("e_interior", [](const StateRecord& p) { return p.interior_void_ratio; });
  add("C_n", [](const StateRecord& p) { return p.micro.coordination_number; });
  add("C_n_all_grains", [](const StateRecord& p) { return p.coordination_number_all; });
  add("C_n_all_grains_error", [](const StateRecord& p) { return p.coordination_error; });
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
  add("contacts", [](const StateRecord& p) { return static_cast<double>(p.contacts); });
  add("G_hh_Pa", [](const StateRecord& p) { return p.G_hh(); });
  add("G_vh_Pa", [](const StateRecord& p) { return p.G_vh(); });
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
  add("unbalanced_force_ratio", [](const StateRecord& p) { return p.unbalanced_force_ratio; });
  add("rest_steps", [](const StateRecord& p) { return static_cast<double>(p.rest_steps); });
  matrix("network_C", &StateRecord::network);
  matrix("affine_C", &StateRecord::affine);
  return columns;
}

} // namespace

std::string frozen_states_csv(const Experiment& experiment) {
  return csv_of(experiment, &PathRun::points, frozen_state_columns());
}

std::string curves_csv(const Experiment& experiment) {
  using Point = triaxial::PathPoint;
  return csv_of<Point>(experiment, &PathRun::curve,
                       {{"eta", "", [](const Point& p) { return p.stress.ratio(); }},
                        {"p_Pa", "", [](const Point& p) { return p.stress.mean(); }},
                        {"s_v_Pa", "", [](const Point& p) { return p.stress.v; }},
                        {"s_h_Pa", "", [](const Point& p) { return p.stress.h; }},
                        {"axial_strain", "", [](const Point& p) { return p.axial_strain; }},
                        {"volumetric_strain", "", [](const Point& p) { return p.volumetric_strain; }},
                        {"work_J_per_m3", "", [](const Point& p) { return p.work; }},
                        {"step", "", [](const Point& p) { return static_cast<double>(p.step); }}});
}

std::string loops_csv(const Experiment& experiment) {
  return rows_of(experiment, headed(experiment, {"eta", "shear_strain", "shear_stress_Pa"}), &PathRun::loops,
                 [](io::CsvContent& csv, const Cells& cells, const ShearLoop& loop) {
                   for (const triaxial::LoopPoint& point : loop.points) {
                     Cells row = cells;
                     append(row, {loop.eta, point.shear_strain, point.shear_stress});
                     csv.rows.push_back(std::move(row));
                   }
                 });
}

std::string histograms_csv(const Experiment& experiment) {
  return rows_of(experiment,
                 headed(experiment, {"eta", "axial_strain", "of", "bin_low", "bin_high", "contacts"}),
                 &PathRun::points, [](io::CsvContent& csv, const Cells& cells, const StateRecord& p) {
                   const auto add = [&](const char* of, const auto& counts, double width) {
                     for (std::size_t k = 0; k < counts.size(); ++k) {
                       Cells row = cells;
                       append(row, {p.at.stress.ratio(), p.at.axial_strain});
                       row.emplace_back(std::string(of));
                       const double low = static_cast<double>(k) * width;
                       append(row, {low, low + width, static_cast<double>(counts[k])});
                       csv.rows.push_back(std::move(row));
                     }
                   };
                   add("polar angle [deg]", p.polar_counts, 90.0 / static_cast<double>(polar_bins));
                   add("f_n/<f_n>", p.force_counts, 8.0 / static_cast<double>(force_bins));
                 });
}

std::string table_csv(const std::vector<TableRow>& rows) {
  io::CsvContent csv;
  csv.headings = {"contact", "density",    "quantity", "granum", "standard_error",
                  "paper",   "difference", "reach",    "within"};
  for (const TableRow& row : rows)
    for (const Cell& cell : row.cells)
      csv.rows.push_back({words(name(row.contact)), words(name(row.density)), cell.quantity, cell.ours.value,
                          cell.ours.standard_error.value_or(io::empty_cell),
                          cell.printed.value_or(io::empty_cell),
                          cell.printed ? cell.ours.value - *cell.printed : io::empty_cell,
                          cell.reach.value_or(io::empty_cell), std::string(answer(cell.agreement()))});
  return io::csv_text(csv);
}

std::string verdicts_csv(const std::vector<Verdict>& verdicts) {
  const io::Columns<Verdict> columns = {
      {"claim", [](const Verdict& verdict) { return verdict.claim; }},
      {"holds", [](const Verdict& verdict) { return std::string(verdict.holds ? "yes" : "no"); }},
      {"measured", [](const Verdict& verdict) { return verdict.measured; }}};
  return io::csv_text(columns, verdicts);
}

std::string table_text(const std::string& title, const std::vector<TableRow>& rows) {
  std::string out = title + "\n";
  const TableRow* widest = nullptr;
  for (const TableRow& row : rows)
    if (widest == nullptr || row.cells.size() > widest->cells.size())
      widest = &row;
  if (widest == nullptr || widest->cells.empty())
    return out + "  nothing was measured\n";
  std::vector<std::size_t> widths;
  std::string head = "  " + padded("contact", 10) + padded("density", 8);
  for (std::size_t k = 0; k < widest->cells.size(); ++k) {
    std::size_t width = widest->cells[k].quantity.size();
    for (const TableRow& row : rows)
      if (k < row.cells.size())
        width = std::max(width, shown(row.cells[k]).size());
    widths.push_back(width + 2);
    head += padded(widest->cells[k].quantity, widths.back());
  }
  out += head + "\n";
  for (const TableRow& row : rows) {
    out += "  " + padded(words(name(row.contact)), 10) + padded(words(name(row.density)), 8);
    for (std::size_t k = 0; k < row.cells.size(); ++k)
      out += padded(shown(row.cells[k]), widths[k]);
    out += "\n";
  }
  return out;
}

} // namespace granum::studies
