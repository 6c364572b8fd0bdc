// SPDX-License-Identifier: GPL-3.0-or-later
// Files of an experiment with a row for each state, point or bin.
#include <fmt/format.h>
#include <granum/core/version.hpp>

#include "reproduce_document.hpp"

namespace granum::cli {

namespace {

using studies::ClosedForms;
using studies::Probes;
using triaxial::PathPoint;

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

} // namespace

Files row_files(const Experiment& experiment) {
  return {{"states.csv", states_csv(experiment)},
          {"curves.csv", curves_csv(experiment)},
          {"loops.csv", loops_csv(experiment)},
          {"histograms.csv", histograms_csv(experiment)}};
}

} // namespace granum::cli
