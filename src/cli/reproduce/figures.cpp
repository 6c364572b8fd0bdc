// SPDX-License-Identifier: GPL-3.0-or-later
// What figures have in common, and those of stress, strain and moduli along the paths.
#include "figures.hpp"

#include <algorithm>
#include <array>
#include <climits>
#include <cmath>
#include <iterator>

#include "studies/reproduce/experiment_findings.hpp"
#include <fmt/format.h>
#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/elastic/isotropic.hpp>

namespace granum::cli {

namespace {

using elastic::TransverselyIsotropic;
using plot::Mark;
using plot::Tone;
using studies::ClosedForms;
using studies::Quantity;
using triaxial::PathPoint;

/// Number of frozen states up to the first peak: all before |eta| is lower than it was.
std::ptrdiff_t rising(const PathRun& run) {
  const auto last = std::ranges::adjacent_find(run.points, [](const StateRecord& a, const StateRecord& b) {
    return std::abs(b.at.stress.ratio()) < std::abs(a.at.stress.ratio());
  });
  return run.path && last != run.points.end() ? last - run.points.begin() + 1 : std::ssize(run.points);
}

Points part(const PathRun& run, std::ptrdiff_t first, std::ptrdiff_t end) {
  Points out;
  for (std::ptrdiff_t k = first; k < end; ++k)
    out.push_back(&run.points[static_cast<std::size_t>(k)]);
  return out;
}

std::size_t style_of(const std::optional<stress::ShearPath>& path) {
  const auto& paths = stress::all_shear_paths;
  return path ? static_cast<std::size_t>(std::ranges::find(paths, *path) - paths.begin()) : paths.size();
}

plot::Colour colour_of_path(const std::optional<stress::ShearPath>& path) {
  using enum plot::Colour;
  constexpr std::array colours{txc, rtxc, rtxe, txe, measured}; // as all_shear_paths
  return colours[style_of(path)];
}

/// G of the nearest isotropic material; empty for a network without stiffness.
std::optional<double> isotropic_G(const elastic::VoigtStiffness& stiffness) {
  try {
    return elastic::isotropic_projection(stiffness).shear_modulus();
  } catch (const InvalidArgument&) {
    return std::nullopt;
  }
}

} // namespace

std::string Kind::title() const { return fmt::format("{}, {}", name(contact), studies::name(density)); }

std::string Kind::key() const {
  std::string text = fmt::format("{}_{}", name(contact), studies::name(density));
  std::replace(text.begin(), text.end(), '-', '_');
  return text;
}

std::vector<Kind> kinds(const Experiment& experiment) {
  std::vector<Kind> out;
  for (const ExperimentSpecimen& specimen : experiment.specimens)
    if (std::ranges::none_of(out, [&](const Kind& kind) {
          return kind.contact == specimen.contact && kind.density == specimen.density;
        }))
      out.push_back({.contact = specimen.contact, .density = specimen.density, .specimen = &specimen});
  return out;
}

Figure figure_of(const Experiment& experiment, std::string name, std::string title,
                 const std::string& caption) {
  const std::size_t seeds = experiment.scene.study.seeds;
  return {.name = std::move(name),
          .title = std::move(title),
          .caption =
              caption +
              (seeds > 1 ? fmt::format(" Drawn is the first of {} specimens of each kind.", seeds) : "")};
}

void add(Figure& to, Panel panel) {
  if (!panel.chart.series.empty())
    to.panels.push_back(std::move(panel));
}

Quantity stress_ratio() { return {"eta", {.title = "\u03b7 = q/p'"}}; }
Quantity mean_stress() { return {"p_Pa", {.title = "p' [kPa]", .unit = 1e3}}; }

Points up_to_peak(const PathRun& run) { return part(run, 0, rising(run)); }
Points past_peak(const PathRun& run) { return part(run, rising(run), std::ssize(run.points)); }

Points from_start(const ExperimentSpecimen& specimen, const PathRun& run) {
  Points out = up_to_peak(run);
  const PathRun* iso = find_run(specimen, std::nullopt);
  if (run.path && !out.empty() && iso != nullptr && !iso->points.empty())
    out.insert(out.begin(), &iso->points.back());
  return out;
}

std::optional<double> eta_of(const StateRecord& point) { return point.at.stress.ratio(); }
std::optional<double> mean_stress_of(const StateRecord& point) { return point.at.stress.mean(); }

std::optional<double> network_over_uniform_strain(const StateRecord& point) {
  if (!point.closed)
    return std::nullopt;
  elastic::VoigtStiffness relaxed;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      relaxed.matrix(i, j) = point.network[static_cast<std::size_t>(6 * i + j)];
  const std::optional<double> network = isotropic_G(relaxed);
  const std::optional<double> uniform = isotropic_G(voigt(point.closed->uniform_strain));
  return network && uniform ? std::optional(*network / *uniform) : std::nullopt;
}

plot::Series series_of(const PathRun& run, const Points& points, const Coordinate& x, const Coordinate& y,
                       Mark mark, Tone tone) {
  plot::Series out{.name = std::string(studies::name(run.path)),
                   .mark = mark,
                   .style = style_of(run.path),
                   .tone = tone,
                   .colour = colour_of_path(run.path)};
  for (const StateRecord* point : points)
    if (const std::optional<double> across = x(*point), up = y(*point); across && up)
      out.add(*across, *up);
  return out;
}

// ---- stress and strain

namespace {

/// Fig. 4, of the first specimen in the tables' order of contacts and densities.
Figure stress_paths(const Experiment& experiment) {
  Figure out = figure_of(
      experiment, "Fig. 4", "Stress paths and the states that were frozen",
      "Every marker is a state that was frozen, measured and solved as a contact network. From the isotropic "
      "state TXC raises the vertical stress and RTXC lowers the horizontal one; RTXE lowers the vertical "
      "stress and TXE raises the horizontal one. Past its peak a path comes back along its own line.");
  for (const Kind& kind : kinds(experiment)) {
    Panel paths = studies::panel("fig04_" + kind.key(), kind.title(), mean_stress(),
                                 {"q_Pa", {.title = "q [kPa]", .unit = 1e3}});
    for (const PathRun& run : kind.specimen->runs)
      add(paths,
          series_of(
              run, part(run, 0, std::ssize(run.points)), mean_stress_of,
              [](const StateRecord& point) { return std::optional(point.at.stress.deviator()); },
              Mark::marker, Tone::faint),
          std::string(studies::name(run.path)));
    add(out, std::move(paths));
    if (!out.panels.empty())
      break; // the paths are the same for all
  }
  return out;
}

/// A line along each shear path of every specimen, from its finely measured curve.
Figure curves(Figure out, const Experiment& experiment, const std::string& stem, const Quantity& y,
              double (*of)(const PathPoint&)) {
  for (const Kind& kind : kinds(experiment)) {
    Panel all = studies::panel(stem + "_" + kind.key(), kind.title(),
                               {"axial_strain", {.title = "axial strain [%]", .unit = 0.01}}, y);
    for (const PathRun& run : kind.specimen->runs) {
      plot::Series line = series_of(run, {}, {}, {});
      for (const PathPoint& point : run.curve)
        line.add(point.axial_strain, of(point));
      add(all, std::move(line), std::string(studies::name(run.path)));
    }
    add(out, std::move(all));
  }
  return out;
}

/// Fig. 8: a panel for each eta, because their stresses differ.
Figure shear_loops(const Experiment& experiment) {
  Figure out = figure_of(
      experiment, "Fig. 8", "Cycles of horizontal shear with friction",
      "Frozen states of TXC, sheared to one side, to the other, and to the first again at constant normal "
      "stresses, at rest at every point. Contacts may slide: a loop that encloses an area, or does not "
      "close, dissipates energy by friction. G_hh is the slope at its start.");
  for (const Kind& kind : kinds(experiment))
    for (const PathRun& run : kind.specimen->runs)
      for (std::size_t k = 0; k < run.loops.size(); ++k) {
        const studies::ShearLoop& loop = run.loops[k];
        Panel cycle = studies::panel(
            fmt::format("fig08_{}_{}", kind.key(), k + 1),
            kind.title() + ", \u03b7 = " + short_text(std::abs(loop.eta) < 1e-3 ? 0 : loop.eta, 2),
            {"shear_strain", {.title = "shear strain [10\u207b\u2076]", .unit = 1e-6}},
            {"shear_stress_Pa", {.title = "shear stress [kPa]", .unit = 1e3}});
        plot::Series line = series_of(run, {}, {}, {}, Mark::both);
        line.name.clear();
        for (const triaxial::LoopPoint& point : loop.points)
          line.add(point.shear_strain, point.shear_stress);
        add(cycle, std::move(line), "cycle");
        add(out, std::move(cycle));
      }
  return out;
}

// ---- moduli

/// One of the three moduli and its routes.
struct Modulus {
  const char* symbol;
  studies::ModulusOf network, probe;
  double (TransverselyIsotropic::*closed)() const;
};
constexpr Modulus moduli[] = {
    {"G_hh", studies::network_G_hh, studies::probe_G_hh, &TransverselyIsotropic::G_hh},
    {"G_hv", studies::network_G_vh, studies::probe_G_hv, &TransverselyIsotropic::G_vh},
    {"G_vh", studies::network_G_vh, studies::probe_G_vh, &TransverselyIsotropic::G_vh}};

/// Adds a series that many runs have in common; the legend lists it once.
void add_common(Panel& to, plot::Series series, const PathRun& run, const std::string& common) {
  const bool listed =
      std::ranges::find(to.chart.series, common, &plot::Series::name) != to.chart.series.end();
  series.name = listed ? "" : common;
  add(to, std::move(series), fmt::format("{} {}", studies::name(run.path), common));
}

/// One modulus of a specimen on all paths; isotropic compression only if x differs between its states.
Panel panel_of(const Kind& kind, const std::string& stem, const Modulus& modulus, const Quantity& x,
               const Coordinate& across, bool with_iso) {
  const std::string symbol = modulus.symbol;
  Panel out = studies::panel(stem, symbol + ": " + kind.title(), x,
                             {symbol + "_Pa", {.title = symbol + " [MPa]", .unit = 1e6}});
  std::vector<const PathRun*> runs;
  for (const PathRun& run : kind.specimen->runs)
    if (run.path || with_iso)
      runs.push_back(&run);
  using Estimate = std::pair<TransverselyIsotropic ClosedForms::*, const char*>;
  for (const PathRun* run : runs) {
    std::size_t dashes = 0;
    for (const auto& [of, legend] : {Estimate{&ClosedForms::uniform_strain, "uniform strain"},
                                     Estimate{&ClosedForms::relaxed, "relaxed (closed form)"}}) {
      plot::Series line = series_of(
          *run, from_start(*kind.specimen, *run), across,
          [&modulus, of = of](const StateRecord& point) {
            return point.closed ? std::optional(((*point.closed.*of).*modulus.closed)()) : std::nullopt;
          },
          Mark::line, Tone::grey);
      line.style = dashes++;
      add_common(out, std::move(line), *run, legend);
    }
  }
  for (const PathRun* run : runs)
    add_common(out, series_of(*run, past_peak(*run), across, modulus.network, Mark::marker, Tone::faint),
               *run, "past the peak");
  for (const PathRun* run : runs)
    add(out, series_of(*run, from_start(*kind.specimen, *run), across, modulus.network),
        fmt::format("{} network", studies::name(run->path)));
  for (const PathRun* run : runs)
    add_common(out, series_of(*run, up_to_peak(*run), across, modulus.probe, Mark::marker), *run,
               "cyclic shear");
  return out;
}

/// Number of the paper's figure; empty for a contact that is not in it.
std::optional<int> figure_number(const Kind& kind) {
  using contact::Shape;
  constexpr std::array in_order{Shape::cone, Shape::sphere, Shape::flat};
  const auto* const found = std::ranges::find(in_order, kind.contact);
  const int first = kind.density == triaxial::Density::dense ? 9 : 12;
  return found != in_order.end() ? std::optional(first + static_cast<int>(found - in_order.begin()))
                                 : std::nullopt;
}

} // namespace

void add_path_figures(std::vector<Figure>& to, const Experiment& experiment) {
  to.push_back(stress_paths(experiment));
  to.push_back(curves(
      figure_of(
          experiment, "Fig. 6", "Stress ratio against axial strain",
          "Compression is positive: TXC and RTXC go to the upper right, RTXE and TXE to the lower left."),
      experiment, "fig06", stress_ratio(), [](const PathPoint& p) { return p.stress.ratio(); }));
  to.push_back(curves(figure_of(experiment, "Fig. 7", "Volumetric strain against axial strain",
                                "Compression is positive: the curve of a specimen that dilates goes down."),
                      experiment, "fig07",
                      {"volumetric_strain", {.title = "volumetric strain [%]", .unit = 0.01}},
                      [](const PathPoint& p) { return p.volumetric_strain; }));
  to.push_back(shear_loops(experiment));
}

void add_modulus_figures(std::vector<Figure>& to, const Experiment& experiment) {
  std::vector<std::pair<int, Figure>> all; // in the order of their numbers, dense before loose
  for (const Kind& kind : kinds(experiment)) {
    const std::optional<int> number = figure_number(kind);
    Figure out = figure_of(
        experiment, number ? fmt::format("Fig. {}", *number) : "Beyond the paper",
        "Shear moduli of the specimen " + kind.title(),
        "Lines: the relaxed contact network of each frozen state, up to the peak; small dots: the same past "
        "the peak. Markers: cyclic shear of the frozen specimen. Grey: closed forms from C_n, void ratio, "
        "fabric and stress, full line under uniform strain, dashed line relaxed with z*. A network has one "
        "modulus G_hv = G_vh, the mean over both vertical planes; cyclic shear measures both, in one of the "
        "planes.");
    for (const Modulus& modulus : moduli) {
      const std::string stem = fmt::format("{}_{}_{}", number ? fmt::format("fig{:02}", *number) : "more",
                                           kind.key(), modulus.symbol);
      add(out, panel_of(kind, stem + "_eta", modulus, stress_ratio(), eta_of, false));
      add(out, panel_of(kind, stem + "_p", modulus, mean_stress(), mean_stress_of, true));
    }
    all.emplace_back(number.value_or(INT_MAX), std::move(out));
  }
  std::ranges::stable_sort(all, {}, &std::pair<int, Figure>::first);
  for (auto& [number, figure] : all)
    to.push_back(std::move(figure));
}

std::vector<Figure> experiment_figures(const Experiment& experiment) {
  std::vector<Figure> figures;
  add_path_figures(figures, experiment);
  add_modulus_figures(figures, experiment);
  add_structure_figures(figures, experiment);
  std::erase_if(figures, [](const Figure& figure) { return figure.panels.empty(); });
  return figures;
}

} // namespace granum::cli
