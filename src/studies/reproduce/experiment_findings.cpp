// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/reproduce/experiment_findings.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <tuple>

#include "studies/paper/paper.hpp"
#include <granum/core/text.hpp>
#include <granum/hardin/fit.hpp>

namespace granum::studies {

const PathRun* find_run(const ExperimentSpecimen& specimen, const std::optional<stress::ShearPath>& path) {
  const auto found = std::ranges::find(specimen.runs, path, &PathRun::path);
  return found == specimen.runs.end() ? nullptr : &*found;
}

std::optional<double> network_G_hh(const StateRecord& point) { return point.G_hh(); }
std::optional<double> network_G_vh(const StateRecord& point) { return point.G_vh(); }

namespace {

template <double Probes::*Of>
std::optional<double> probed(const StateRecord& point) {
  return point.probes ? std::optional((*point.probes).*Of) : std::nullopt;
}

} // namespace

std::optional<double> probe_G_hh(const StateRecord& point) { return probed<&Probes::G_hh>(point); }
std::optional<double> probe_G_hv(const StateRecord& point) { return probed<&Probes::G_hv>(point); }
std::optional<double> probe_G_vh(const StateRecord& point) { return probed<&Probes::G_vh>(point); }

namespace {

using triaxial::Density;
using Points = std::vector<const StateRecord*>;

/// eta up to which the paper fits its Table 5 and calls a dense specimen's structure constant.
constexpr double early_eta = 0.6;
/// Cells of further_exponents that a claim needs.
constexpr const char* exponent_of_horizontal = "exponent of sigma_h in G_hh";
constexpr const char* exponent_of_vertical = "exponent of sigma_v in G_hh";

/// Frozen states of the shear paths with |eta| <= early_eta, not counting those past the peak.
Points early_points(const ExperimentSpecimen& specimen) {
  constexpr double margin = 0.01; // a snapshot at a multiple of eta is taken just after it
  Points out;
  for (const PathRun& run : specimen.runs)
    for (const StateRecord& point : run.points) {
      // Past the peak eta may fall below the limit again: the path has left the range for good.
      if (!run.path || std::abs(point.at.stress.ratio()) > early_eta + margin)
        break;
      out.push_back(&point);
    }
  return out;
}

/// One column of a table: the measured quantity of a specimen, empty if not measured; the paper's value; and
/// the limits of their difference for dense and loose.
struct Column {
  std::string quantity;
  std::function<std::optional<TableValue>(const ExperimentSpecimen&)> measure;
  std::function<std::optional<double>(const PrintedSpecimen&)> print = {};
  double reach_dense = 0, reach_loose = reach_dense;
};

std::vector<Cell> table(const Experiment& experiment, const std::vector<Column>& columns) {
  std::vector<Cell> cells;
  for (const contact::Shape contact : experiment.scene.study.contacts)
    for (const Density density : experiment.scene.study.densities) {
      const std::optional<PrintedSpecimen> paper = printed(contact, density);
      for (const Column& column : columns) {
        std::vector<TableValue> each;
        for (const ExperimentSpecimen& specimen : experiment.specimens)
          if (specimen.contact == contact && specimen.density == density)
            if (const std::optional<TableValue> one = column.measure(specimen))
              each.push_back(*one);
        const std::optional<TableValue> mean = mean_over_seeds(each);
        if (!mean)
          continue;
        Cell& cell = cells.emplace_back(Cell{contact, density, column.quantity, *mean});
        if (paper && column.print)
          cell.printed = column.print(*paper);
        if (cell.printed)
          cell.reach = density == Density::dense ? column.reach_dense : column.reach_loose;
      }
    }
  return cells;
}

/// A quantity of the first frozen state.
auto at_start(TableValue (*of)(const StateRecord&)) {
  return [of](const ExperimentSpecimen& specimen) {
    const std::vector<StateRecord>& points = specimen.runs.front().points;
    return points.empty() ? std::nullopt : std::optional(of(points.front()));
  };
}

using PartOf = Measured (*)(const hardin::Fit&);
Measured exponent_m(const hardin::Fit& fit) { return *fit.exponent_i; }
Measured exponent_n(const hardin::Fit& fit) { return *fit.exponent_j; }
Measured exponent_s(const hardin::Fit& fit) { return fit.exponent_sum; }
Measured coefficient(const hardin::Fit& fit) { return fit.coefficient; }

/// Eq. (1) fitted to the moduli of one specimen with m of sigma_h and n of sigma_v, or with s of sigma_h
/// alone; a part of the fit.
auto fitted(ModulusOf modulus, PartOf part, bool two_exponents = true) {
  return [=](const ExperimentSpecimen& specimen) -> std::optional<TableValue> {
    const Points early = early_points(specimen);
    Points points = early;
    for (const StateRecord& point : specimen.runs.front().points)
      points.push_back(&point);
    std::vector<hardin::MeasuredModulus> rows;
    for (const StateRecord* point : points)
      if (const std::optional<double> G = modulus(*point); G && *G > 0)
        rows.push_back(
            {*G, {point->stress.h, two_exponents ? point->stress.v : point->stress.h, point->void_ratio}});
    if (rows.size() < 4 || early.empty())
      return std::nullopt;
    const hardin::FitOptions options{.atmospheric_pressure = 100e3,
                                     .void_ratio_function = hardin::VoidRatioFunction::hardin_richart_round,
                                     .weights = hardin::Weights::absolute};
    const hardin::FitReport report =
        two_exponents ? hardin::fit(rows, options) : hardin::fit_exponent_sum(rows, options);
    if (report.status() != hardin::FitStatus::converged)
      return std::nullopt;
    const Measured estimate = part(report.fit());
    return TableValue{estimate.value, estimate.standard_error};
  };
}

// s as the paper prints it.
double printed_hh(const PrintedSpecimen& paper) { return paper.hh.s; }
double printed_hv(const PrintedSpecimen& paper) { return paper.hv.s; }
double printed_vh(const PrintedSpecimen& paper) { return paper.vh.s; }

} // namespace

Agreement Cell::agreement() const {
  if (!printed || !reach)
    return Agreement::not_asked;
  if (ours.standard_error && *ours.standard_error > *reach)
    return Agreement::undecided;
  return std::abs(ours.value - *printed) <= *reach ? Agreement::within : Agreement::beyond;
}

std::vector<Cell> table_2(const Experiment& experiment) {
  return table(experiment,
               {{"C_n", at_start([](const StateRecord& point) {
                   return TableValue{point.coordination_number_all, point.coordination_error};
                 }),
                 [](const PrintedSpecimen& paper) { return paper.coordination_number; }, 0.4},
                // Between walls two diameters inside: layers at the walls raise e of 10,000 grains by 0.06.
                {"e", at_start([](const StateRecord& point) {
                   return TableValue{point.interior_void_ratio, {}};
                 }),
                 [](const PrintedSpecimen& paper) { return paper.void_ratio; }, 0.02}});
}

std::vector<Cell> table_4(const Experiment& experiment) {
  std::vector<Column> columns;
  for (std::size_t k = 0; k < stress::all_shear_paths.size(); ++k) {
    const stress::ShearPath path = stress::all_shear_paths[k];
    columns.push_back(
        {std::string(stress::name(path)) + " [deg]",
         [path](const ExperimentSpecimen& specimen) -> std::optional<TableValue> {
           const PathRun* run = find_run(specimen, path);
           if (run == nullptr || !run->failure.empty())
             return std::nullopt;
           return TableValue{stress::mobilised_friction_angle(run->peak.stress) * 180 / std::numbers::pi, {}};
         },
         [k](const PrintedSpecimen& paper) { return paper.friction_angle[k]; }, 1.5});
  }
  return table(experiment, columns);
}

std::vector<Cell> table_5(const Experiment& experiment) {
  return table(experiment, {{"s of G_hh", fitted(network_G_hh, exponent_s, false), printed_hh, 0.04, 0.08},
                            {"m of G_hv", fitted(network_G_vh, exponent_m),
                             [](const PrintedSpecimen& paper) { return paper.hv.m; }, 0.05, 0.10},
                            {"n of G_hv", fitted(network_G_vh, exponent_n),
                             [](const PrintedSpecimen& paper) { return paper.hv.n; }, 0.05, 0.10},
                            {"s of G_hv", fitted(network_G_vh, exponent_s), printed_hv, 0.04, 0.08},
                            {"C of G_hv", fitted(network_G_vh, coefficient)}});
}

std::vector<Cell> further_exponents(const Experiment& experiment) {
  return table(experiment,
               {{exponent_of_horizontal, fitted(network_G_hh, exponent_m)},
                {exponent_of_vertical, fitted(network_G_hh, exponent_n)},
                {"s of G_hh, probes", fitted(probe_G_hh, exponent_s, false), printed_hh, 0.04, 0.08},
                {"s of G_hv, probes", fitted(probe_G_hv, exponent_s), printed_hv, 0.04, 0.08},
                {"s of G_vh, probes", fitted(probe_G_vh, exponent_s), printed_vh, 0.04, 0.08}});
}

// ---- claims

namespace {

void judge(std::vector<Verdict>& out, std::string claim, bool holds, std::string measured) {
  out.push_back({std::move(claim), holds, std::move(measured)});
}

std::string title(const ExperimentSpecimen& specimen) {
  return std::string(name(specimen.density)) + " " + std::string(name(specimen.contact)) + " (seed " +
         std::to_string(specimen.seed) + ")";
}

/// Cells with a printed value: how many are near to it, and the largest distance.
struct Near {
  double cells = 0, within = 0, worst = 0;

  void take(const Cell& cell, bool near) {
    ++cells;
    within += near;
    worst = std::max(worst, std::abs(cell.ours.value - *cell.printed));
  }
  [[nodiscard]] std::string text() const { return detail::formatted("%.0f of %.0f", within, cells); }
};

Near near(const std::vector<Cell>& cells, double distance, const std::string& quantity = {}) {
  Near out;
  for (const Cell& cell : cells)
    if (cell.printed && (quantity.empty() || cell.quantity == quantity))
      out.take(cell, std::abs(cell.ours.value - *cell.printed) <= distance);
  return out;
}

void judge_all_near(std::vector<Verdict>& out, const std::string& claim, const Near& near) {
  if (near.cells > 0)
    judge(out, claim, near.within == near.cells, near.text() + detail::formatted(", worst %.3g", near.worst));
}

void judge_tables(std::vector<Verdict>& out, const Experiment& experiment) {
  const std::vector<Cell> initial = table_2(experiment), peaks = table_4(experiment);
  judge_all_near(out, "Table 2: C_n within 0.4 of the paper", near(initial, 0.4, "C_n"));
  judge_all_near(out, "Table 2: e within 0.02 of the paper", near(initial, 0.02, "e"));
  if (const Near close = near(peaks, 1.5); close.cells > 0)
    judge(out, "Table 4: five of six friction angles within 1.5 deg of the paper",
          6 * close.within >= 5 * close.cells, close.text());
  judge_all_near(out, "Table 4: all friction angles within 2.5 deg of the paper", near(peaks, 2.5));
  const std::vector<Cell> fits = table_5(experiment);
  for (const auto& [letters, of_dense, of_loose] :
       {std::tuple{std::string("s"), "s within 0.04", "s within 0.08"},
        std::tuple{std::string("mn"), "m and n within 0.05", "m and n within 0.10"}})
    for (const Density density : experiment.scene.study.densities) {
      Near all;
      for (const Cell& cell : fits)
        if (cell.density == density && letters.find(cell.quantity.front()) != std::string::npos &&
            cell.agreement() != Agreement::not_asked)
          all.take(cell, cell.agreement() == Agreement::within);
      judge_all_near(out,
                     "Table 5, " + std::string(name(density)) + ": " +
                         (density == Density::dense ? of_dense : of_loose) + " of the paper",
                     all);
    }
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
  judge(out, title(specimen) + ": C_n within 3 % of its start for |q/p'| <= 0.6", coordination <= 0.03,
        detail::formatted("largest relative change %.2g", coordination));
  judge(out, title(specimen) + ": fabric anisotropy a within 0.03 of zero for |q/p'| <= 0.6",
        anisotropy <= 0.03, detail::formatted("worst %.3f +- %.3f", anisotropy, error));
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
    judge(out,
          title(specimen) +
              ": past the peak C_n has decreased and a grown towards the larger stress on every path",
          kept < 0.9 && turned > 0.1,
          detail::formatted("at most %.2f of C_n is left, a is %.2f or more", kept, turned));
}

/// Flat contacts have one stiffness: G changes only with the structure, which dense specimens keep.
void judge_flat(std::vector<Verdict>& out, const ExperimentSpecimen& specimen) {
  const double change = std::max(worst_change(specimen, [](const StateRecord& p) { return p.G_vh(); }),
                                 worst_change(specimen, [](const StateRecord& p) { return p.G_hh(); }));
  const bool dense = specimen.density == Density::dense;
  judge(out,
        title(specimen) + (dense ? ": G constant" : ": G not constant") + " within 5 % for |q/p'| <= 0.6",
        dense ? change <= 0.05 : change > 0.05, detail::formatted("largest relative change %.2g", change));
}

/// In the paper G_hh depends on sigma_h only.
void judge_horizontal_shear(std::vector<Verdict>& out, const Experiment& experiment) {
  const std::vector<Cell> cells = further_exponents(experiment);
  for (const Cell& vertical : cells)
    for (const Cell& horizontal : cells)
      if (vertical.density == Density::dense && horizontal.density == Density::dense &&
          vertical.contact == horizontal.contact && vertical.quantity == exponent_of_vertical &&
          horizontal.quantity == exponent_of_horizontal) {
        const double exponent = vertical.ours.value, error = vertical.ours.standard_error.value_or(0);
        judge(out, "dense " + std::string(name(vertical.contact)) + ": G_hh does not depend on sigma_v",
              std::abs(exponent) <= 2 * error,
              detail::formatted("exponent of sigma_v %.3f +- %.3f, of sigma_h %.3f", exponent, error,
                                horizontal.ours.value));
      }
}

/// Largest difference of G_hv and G_vh by cyclic shear before 0.9 of failure.
void judge_vertical_shear(std::vector<Verdict>& out, const Experiment& experiment) {
  double worst = 0, states = 0;
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
    judge(out, "G_vh = G_hv by cyclic shear up to 0.9 of the peak q/p', within 2 %", worst <= 0.02,
          detail::formatted("worst %.2g in %.0f states", worst, states));
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
        judge(out, title(specimen) + ", " + std::string(name(run.path)) + ": the whole path was run", false,
              run.failure);
  return out;
}

} // namespace granum::studies
