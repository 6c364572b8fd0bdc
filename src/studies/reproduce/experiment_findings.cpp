// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/reproduce/experiment_findings.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "studies/paper/paper.hpp"
#include <granum/core/text.hpp>
#include <granum/hardin/fit.hpp>

namespace granum::studies {

const PathRun* find_run(const ExperimentSpecimen& specimen, const std::optional<stress::ShearPath>& path) {
  const auto found = std::find_if(specimen.runs.begin(), specimen.runs.end(),
                                  [&](const PathRun& run) { return run.path == path; });
  return found == specimen.runs.end() ? nullptr : &*found;
}

std::vector<const StateRecord*> early_points(const ExperimentSpecimen& specimen) {
  // A snapshot at a multiple of eta is taken just after it.
  constexpr double margin = 0.01;
  std::vector<const StateRecord*> out;
  for (const PathRun& run : specimen.runs)
    for (const StateRecord& point : run.points) {
      // Past the peak eta may fall below the limit again: the path has left the range for good.
      if (!run.path || std::abs(point.at.stress.ratio()) > early_eta + margin)
        break;
      out.push_back(&point);
    }
  return out;
}

std::vector<const StateRecord*> fit_points(const ExperimentSpecimen& specimen) {
  std::vector<const StateRecord*> out = early_points(specimen);
  for (const StateRecord& point : specimen.runs.front().points)
    out.push_back(&point);
  return out;
}

std::optional<double> network_G_hh(const StateRecord& point) { return point.G_hh(); }
std::optional<double> network_G_vh(const StateRecord& point) { return point.G_vh(); }

std::optional<double> probe_G_hh(const StateRecord& point) {
  return point.probes ? std::optional(point.probes->G_hh) : std::nullopt;
}
std::optional<double> probe_G_hv(const StateRecord& point) {
  return point.probes ? std::optional(point.probes->G_hv) : std::nullopt;
}
std::optional<double> probe_G_vh(const StateRecord& point) {
  return point.probes ? std::optional(point.probes->G_vh) : std::nullopt;
}

namespace {

using triaxial::Density;

/// A quantity of one specimen; empty if not measured.
using Reading = std::function<std::optional<TableValue>(const ExperimentSpecimen&)>;

/// One column of a table: the measured quantity, the paper's value, and the limit of their difference.
struct Column {
  std::string quantity;
  Reading measure;
  std::function<std::optional<double>(const PrintedSpecimen&)> print;
  double reach_dense = 0;
  double reach_loose = 0;
};

std::vector<TableRow> table(const Experiment& experiment, const std::vector<Column>& columns) {
  std::vector<TableRow> rows;
  for (const contact::Shape contact : experiment.scene.study.contacts)
    for (const Density density : experiment.scene.study.densities) {
      TableRow row{.contact = contact, .density = density, .cells = {}};
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
        Cell cell{.quantity = column.quantity, .ours = *mean, .printed = {}, .reach = {}};
        if (paper && column.print)
          cell.printed = column.print(*paper);
        if (cell.printed)
          cell.reach = density == Density::dense ? column.reach_dense : column.reach_loose;
        row.cells.push_back(cell);
      }
      rows.push_back(row);
    }
  return rows;
}

std::optional<TableValue> initial_coordination(const ExperimentSpecimen& specimen) {
  const std::vector<StateRecord>& points = specimen.runs.front().points;
  if (points.empty())
    return std::nullopt;
  return TableValue{points.front().coordination_number_all, points.front().coordination_error};
}

/// Between walls two diameters inside: layers at the walls raise e of 10,000 grains by 0.06.
std::optional<TableValue> initial_void_ratio(const ExperimentSpecimen& specimen) {
  const std::vector<StateRecord>& points = specimen.runs.front().points;
  if (points.empty())
    return std::nullopt;
  return TableValue{points.front().interior_void_ratio, {}};
}

Reading peak_angle(stress::ShearPath path) {
  return [path](const ExperimentSpecimen& specimen) -> std::optional<TableValue> {
    const PathRun* run = find_run(specimen, path);
    if (run == nullptr || !run->failure.empty())
      return std::nullopt;
    return TableValue{stress::mobilised_friction_angle(run->peak.stress) * 180 / std::numbers::pi, {}};
  };
}

/// Eq. (1) fitted to one specimen; a part of the fit is picked by the caller.
struct FitOf {
  ModulusOf modulus;
  bool two_exponents = true; ///< m of sigma_h and n of sigma_v; else s of sigma_h alone
};

std::optional<hardin::Fit> fitted(const ExperimentSpecimen& specimen, const FitOf& what) {
  std::vector<hardin::MeasuredModulus> rows;
  for (const StateRecord* point : fit_points(specimen))
    if (const std::optional<double> modulus = what.modulus(*point); modulus && *modulus > 0) {
      const double other = what.two_exponents ? point->stress.v : point->stress.h;
      rows.push_back({*modulus, {point->stress.h, other, point->void_ratio}});
    }
  if (rows.size() < 4 || early_points(specimen).empty())
    return std::nullopt;
  const hardin::FitOptions options{.atmospheric_pressure = 100e3,
                                   .void_ratio_function = hardin::VoidRatioFunction::hardin_richart_round,
                                   .weights = hardin::Weights::absolute};
  const hardin::FitReport report =
      what.two_exponents ? hardin::fit(rows, options) : hardin::fit_exponent_sum(rows, options);
  return report.status() == hardin::FitStatus::converged ? std::optional(report.fit()) : std::nullopt;
}

using PartOf = std::function<Measured(const hardin::Fit&)>;

Reading part(FitOf what, PartOf pick) {
  return [what = std::move(what),
          pick = std::move(pick)](const ExperimentSpecimen& specimen) -> std::optional<TableValue> {
    const std::optional<hardin::Fit> fit = fitted(specimen, what);
    if (!fit)
      return std::nullopt;
    const Measured estimate = pick(*fit);
    return TableValue{estimate.value, estimate.standard_error};
  };
}

Measured exponent_m(const hardin::Fit& fit) { return *fit.exponent_i; }
Measured exponent_n(const hardin::Fit& fit) { return *fit.exponent_j; }
Measured exponent_s(const hardin::Fit& fit) { return fit.exponent_sum; }
Measured coefficient(const hardin::Fit& fit) { return fit.coefficient; }

} // namespace

Agreement Cell::agreement() const {
  if (!printed || !reach)
    return Agreement::not_asked;
  if (ours.standard_error && *ours.standard_error > *reach)
    return Agreement::undecided;
  return std::abs(ours.value - *printed) <= *reach ? Agreement::within : Agreement::beyond;
}

std::vector<TableRow> table_2(const Experiment& experiment) {
  return table(experiment, {{"C_n", initial_coordination,
                             [](const PrintedSpecimen& p) { return p.coordination_number; }, 0.4, 0.4},
                            {"e", initial_void_ratio, [](const PrintedSpecimen& p) { return p.void_ratio; },
                             0.02, 0.02}});
}

std::vector<TableRow> table_4(const Experiment& experiment) {
  std::vector<Column> columns;
  for (std::size_t k = 0; k < stress::all_shear_paths.size(); ++k) {
    const stress::ShearPath path = stress::all_shear_paths[k];
    columns.push_back({std::string(stress::name(path)) + " [deg]", peak_angle(path),
                       [k](const PrintedSpecimen& p) { return p.friction_angle[k]; }, 1.5, 1.5});
  }
  return table(experiment, columns);
}

std::vector<TableRow> table_5(const Experiment& experiment) {
  const FitOf hh{network_G_hh, false}, hv{network_G_vh, true};
  return table(
      experiment,
      {{"s of G_hh", part(hh, exponent_s), [](const PrintedSpecimen& p) { return p.hh.s; }, 0.04, 0.08},
       {"m of G_hv", part(hv, exponent_m), [](const PrintedSpecimen& p) { return p.hv.m; }, 0.05, 0.10},
       {"n of G_hv", part(hv, exponent_n), [](const PrintedSpecimen& p) { return p.hv.n; }, 0.05, 0.10},
       {"s of G_hv", part(hv, exponent_s), [](const PrintedSpecimen& p) { return p.hv.s; }, 0.04, 0.08},
       {"C of G_hv", part(hv, coefficient), {}, 0, 0}});
}

std::vector<TableRow> further_exponents(const Experiment& experiment) {
  const FitOf both{network_G_hh, true}, hh{probe_G_hh, false}, hv{probe_G_hv, true}, vh{probe_G_vh, true};
  return table(experiment, {{exponent_h_of_G_hh, part(both, exponent_m), {}, 0, 0},
                            {exponent_v_of_G_hh, part(both, exponent_n), {}, 0, 0},
                            {"s of G_hh, probes", part(hh, exponent_s),
                             [](const PrintedSpecimen& p) { return p.hh.s; }, 0.04, 0.08},
                            {"s of G_hv, probes", part(hv, exponent_s),
                             [](const PrintedSpecimen& p) { return p.hv.s; }, 0.04, 0.08},
                            {"s of G_vh, probes", part(vh, exponent_s),
                             [](const PrintedSpecimen& p) { return p.vh.s; }, 0.04, 0.08}});
}

} // namespace granum::studies
