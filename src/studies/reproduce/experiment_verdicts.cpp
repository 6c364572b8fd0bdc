// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <tuple>

#include "studies/reproduce/experiment_findings.hpp"

#include <granum/core/text.hpp>

namespace granum::studies {

namespace {

using triaxial::Density;

std::string title(const ExperimentSpecimen& specimen) {
  return std::string(name(specimen.density)) + " " + std::string(name(specimen.contact)) + " (seed " +
         std::to_string(specimen.seed) + ")";
}

/// Cells of a table that have a printed value: how many are within a distance of it, and the largest one.
struct Near {
  std::size_t cells = 0;
  std::size_t within = 0;
  double worst = 0;
};

Near near(const std::vector<TableRow>& rows, double distance, const std::string& quantity = {}) {
  Near out;
  for (const TableRow& row : rows)
    for (const Cell& cell : row.cells)
      if (cell.printed && (quantity.empty() || cell.quantity == quantity)) {
        const double difference = std::abs(cell.ours.value - *cell.printed);
        ++out.cells;
        out.within += difference <= distance;
        out.worst = std::max(out.worst, difference);
      }
  return out;
}

void judge_all_near(std::vector<Verdict>& out, const std::string& claim, const Near& near) {
  if (near.cells > 0)
    out.push_back({claim, near.within == near.cells,
                   detail::formatted("%.0f of %.0f, worst ", static_cast<double>(near.within),
                                     static_cast<double>(near.cells)) +
                       detail::formatted("%.3g", near.worst)});
}

void judge_tables(std::vector<Verdict>& out, const Experiment& experiment) {
  const std::vector<TableRow> initial = table_2(experiment), peaks = table_4(experiment);
  judge_all_near(out, "Table 2: C_n within 0.4 of the paper", near(initial, 0.4, "C_n"));
  judge_all_near(out, "Table 2: e within 0.02 of the paper", near(initial, 0.02, "e"));
  if (const Near close = near(peaks, 1.5); close.cells > 0)
    out.push_back({"Table 4: five of six friction angles within 1.5 deg of the paper",
                   6 * close.within >= 5 * close.cells,
                   detail::formatted("%.0f of %.0f", static_cast<double>(close.within),
                                     static_cast<double>(close.cells))});
  judge_all_near(out, "Table 4: all friction angles within 2.5 deg of the paper", near(peaks, 2.5));
  const std::vector<TableRow> fits = table_5(experiment);
  for (const auto& [letter, of_dense, of_loose] :
       {std::tuple{'s', "s within 0.04", "s within 0.08"},
        std::tuple{'m', "m and n within 0.05", "m and n within 0.10"}})
    for (const Density density : experiment.scene.study.densities) {
      const std::string what = density == Density::dense ? of_dense : of_loose;
      Near all;
      for (const TableRow& row : fits)
        for (const Cell& cell : row.cells) {
          const char first = cell.quantity.front() == 'n' ? 'm' : cell.quantity.front();
          if (row.density != density || first != letter || cell.agreement() == Agreement::not_asked)
            continue;
          ++all.cells;
          all.within += cell.agreement() == Agreement::within;
          all.worst = std::max(all.worst, std::abs(cell.ours.value - *cell.printed));
        }
      judge_all_near(
          out, std::string("Table 5, ") + std::string(name(density)) + ": " + what + " of the paper", all);
    }
}

/// Largest difference of G_hv and G_vh by cyclic shear before 0.9 of failure.
void judge_vertical_shear(std::vector<Verdict>& out, const Experiment& experiment) {
  double worst = 0;
  std::size_t states = 0;
  for (const ExperimentSpecimen& specimen : experiment.specimens)
    for (const PathRun& run : specimen.runs)
      for (const StateRecord& point : run.points) {
        if (run.path && std::abs(point.at.stress.ratio()) > 0.9 * std::abs(run.peak.stress.ratio()))
          break;
        if (!point.probes)
          continue;
        worst = std::max(worst, std::abs(point.probes->G_hv / point.probes->G_vh - 1));
        ++states;
      }
  if (states > 0)
    out.push_back({"G_vh = G_hv by cyclic shear up to 0.9 of the peak q/p', within 2 %", worst <= 0.02,
                   detail::formatted("worst %.2g in %.0f states", worst, static_cast<double>(states))});
}

/// Largest distance of a figure from its value at the start of the paths, over |eta| <= 0.6.
double worst_change(const ExperimentSpecimen& specimen, double (*figure)(const StateRecord&)) {
  const double start = figure(specimen.runs.front().points.back());
  double worst = 0;
  for (const StateRecord* point : early_points(specimen))
    worst = std::max(worst, std::abs(figure(*point) / start - 1));
  return worst;
}

/// The paper's picture of dense specimens: their structure stays as it is up to |eta| = 0.6, then contacts
/// are lost and the rest turns towards the larger stress.
void judge_dense_structure(std::vector<Verdict>& out, const ExperimentSpecimen& specimen) {
  const double coordination =
      worst_change(specimen, [](const StateRecord& p) { return p.micro.coordination_number; });
  double anisotropy = 0, error = 0;
  for (const StateRecord* point : early_points(specimen))
    if (std::abs(point->micro.fabric_anisotropy) > anisotropy) {
      anisotropy = std::abs(point->micro.fabric_anisotropy);
      error = point->micro.fabric_anisotropy_error;
    }
  out.push_back({title(specimen) + ": C_n within 3 % of its start for |q/p'| <= 0.6", coordination <= 0.03,
                 detail::formatted("largest relative change %.2g", coordination)});
  out.push_back({title(specimen) + ": fabric anisotropy a within 0.03 of zero for |q/p'| <= 0.6",
                 anisotropy <= 0.03, detail::formatted("worst %.3f +- %.3f", anisotropy, error)});
  double kept = 0, turned = 10;
  for (const PathRun& run : specimen.runs)
    if (run.path && !run.points.empty() && run.failure.empty()) {
      const analysis::Microstructure &first = specimen.runs.front().points.back().micro,
                                     &last = run.points.back().micro;
      const double sense = stress::is_compression(*run.path) ? 1 : -1;
      kept = std::max(kept, last.coordination_number / first.coordination_number);
      turned = std::min(turned, sense * last.fabric_anisotropy);
    }
  if (kept > 0)
    out.push_back({title(specimen) + ": past the peak C_n has decreased and a grown towards the larger "
                                     "stress on every path",
                   kept < 0.9 && turned > 0.1,
                   detail::formatted("at most %.2f of C_n is left, a is %.2f or more", kept, turned)});
}

double G_vh_of(const StateRecord& point) { return point.G_vh(); }
double G_hh_of(const StateRecord& point) { return point.G_hh(); }

/// Flat contacts have one stiffness: G changes only with the structure, which dense specimens keep.
void judge_flat(std::vector<Verdict>& out, const ExperimentSpecimen& specimen) {
  const double change = std::max(worst_change(specimen, G_vh_of), worst_change(specimen, G_hh_of));
  if (specimen.density == Density::dense)
    out.push_back({title(specimen) + ": G constant within 5 % for |q/p'| <= 0.6", change <= 0.05,
                   detail::formatted("largest relative change %.2g", change)});
  else
    out.push_back({title(specimen) + ": G not constant within 5 % for |q/p'| <= 0.6", change > 0.05,
                   detail::formatted("largest relative change %.2g", change)});
}

/// In the paper G_hh depends on sigma_h only.
void judge_horizontal_shear(std::vector<Verdict>& out, const Experiment& experiment) {
  for (const TableRow& row : further_exponents(experiment)) {
    if (row.density != Density::dense)
      continue;
    const auto find = [&](const char* quantity) {
      return std::find_if(row.cells.begin(), row.cells.end(),
                          [&](const Cell& cell) { return cell.quantity == quantity; });
    };
    const auto vertical = find(exponent_v_of_G_hh), horizontal = find(exponent_h_of_G_hh);
    if (vertical == row.cells.end() || horizontal == row.cells.end())
      continue;
    const double error = vertical->ours.standard_error.value_or(0);
    out.push_back({"dense " + std::string(name(row.contact)) + ": G_hh does not depend on sigma_v",
                   std::abs(vertical->ours.value) <= 2 * error,
                   detail::formatted("exponent of sigma_v %.3f +- %.3f, ", vertical->ours.value, error) +
                       detail::formatted("of sigma_h %.3f", horizontal->ours.value)});
  }
}

} // namespace

std::vector<Verdict> experiment_verdicts(const Experiment& experiment) {
  std::vector<Verdict> out;
  judge_tables(out, experiment);
  for (const ExperimentSpecimen& specimen : experiment.specimens) {
    if (early_points(specimen).empty() || specimen.runs.front().points.empty())
      continue;
    if (specimen.density == Density::dense)
      judge_dense_structure(out, specimen);
    if (specimen.contact == contact::Shape::flat)
      judge_flat(out, specimen);
  }
  judge_horizontal_shear(out, experiment);
  for (Verdict& verdict : out)
    verdict.finding = true;
  judge_vertical_shear(out, experiment);
  for (const ExperimentSpecimen& specimen : experiment.specimens)
    for (const PathRun& run : specimen.runs)
      if (!run.failure.empty())
        out.push_back({title(specimen) + ", " + std::string(name(run.path)) + ": the whole path was run",
                       false, run.failure});
  return out;
}

} // namespace granum::studies
