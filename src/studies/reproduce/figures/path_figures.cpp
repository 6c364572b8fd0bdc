// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <granum/core/text.hpp>

#include "figure_parts.hpp"

namespace granum::studies {

namespace {

using triaxial::PathPoint;

/// One line along each shear path of a specimen, from its finely measured curve.
Panel curves(const Kind& kind, const std::string& stem, const Quantity& y, double (*of)(const PathPoint&)) {
  Panel out = panel(stem + "_" + kind.key(), kind.title(), axial_strain(), y);
  for (const PathRun& run : kind.specimen->runs) {
    plot::Series line{.name = std::string(name(run.path)),
                      .mark = plot::Mark::line,
                      .style = style_of(run.path),
                      .colour = colour_of(run.path)};
    for (const PathPoint& point : run.curve)
      line.add(point.axial_strain, of(point));
    add(out, std::move(line), std::string(name(run.path)));
  }
  return out;
}

/// Fig. 4, of the first specimen in the tables' order of contacts and densities.
Figure stress_paths(const Experiment& experiment) {
  Figure out{
      .name = "Fig. 4",
      .title = "Stress paths and the states that were frozen",
      .caption =
          "Every marker is a state that was frozen, measured and solved as a contact network. From the "
          "isotropic state TXC raises the vertical stress and RTXC lowers the horizontal one; RTXE "
          "lowers the vertical stress and TXE raises the horizontal one. Past its peak a path comes "
          "back along its own line." +
          seeds_note(experiment),
      .panels = {}};
  for (const Kind& kind : kinds(experiment)) {
    Panel paths = panel("fig04_" + kind.key(), kind.title(), mean_stress(),
                        {"q_Pa", {.title = "q [kPa]", .unit = 1e3}});
    for (const PathRun& run : kind.specimen->runs) {
      std::vector<const StateRecord*> points;
      for (const StateRecord& point : run.points)
        points.push_back(&point);
      plot::Series series = series_of(run, points, mean_stress_of, [](const StateRecord& point) {
        return std::optional(point.at.stress.deviator());
      });
      series.mark = plot::Mark::marker;
      series.tone = plot::Tone::faint;
      add(paths, std::move(series), std::string(name(run.path)));
    }
    add(out, std::move(paths));
    if (!out.panels.empty())
      break; // the paths are the same for all
  }
  return out;
}

/// Fig. 8: a panel for each eta, because their stresses differ.
Figure shear_loops(const Experiment& experiment) {
  Figure out{
      .name = "Fig. 8",
      .title = "Cycles of horizontal shear with friction",
      .caption =
          "Frozen states of TXC, sheared to one side, to the other, and to the first again at constant "
          "normal stresses, at rest at every point. Contacts may slide: a loop that encloses an area, "
          "or does not close, dissipates energy by friction. G_hh is the slope at its start." +
          seeds_note(experiment),
      .panels = {}};
  for (const Kind& kind : kinds(experiment))
    for (const PathRun& run : kind.specimen->runs)
      for (std::size_t k = 0; k < run.loops.size(); ++k) {
        const ShearLoop& loop = run.loops[k];
        Panel cycle =
            panel("fig08_" + kind.key() + "_" + std::to_string(k + 1),
                  kind.title() + ", \u03b7 = " + short_text(std::abs(loop.eta) < 1e-3 ? 0 : loop.eta, 2),
                  {"shear_strain", {.title = "shear strain [10\u207b\u2076]", .unit = 1e-6}},
                  {"shear_stress_Pa", {.title = "shear stress [kPa]", .unit = 1e3}});
        plot::Series line{
            .mark = plot::Mark::both, .style = style_of(run.path), .colour = colour_of(run.path)};
        for (const triaxial::LoopPoint& point : loop.points)
          line.add(point.shear_strain, point.shear_stress);
        add(cycle, std::move(line), "cycle");
        add(out, std::move(cycle));
      }
  return out;
}

} // namespace

void add_path_figures(std::vector<Figure>& to, const Experiment& experiment) {
  to.push_back(stress_paths(experiment));
  Figure ratio{.name = "Fig. 6",
               .title = "Stress ratio against axial strain",
               .caption =
                   "Compression is positive: TXC and RTXC go to the upper right, RTXE and TXE to the lower "
                   "left." +
                   seeds_note(experiment),
               .panels = {}};
  Figure volume{.name = "Fig. 7",
                .title = "Volumetric strain against axial strain",
                .caption = "Compression is positive: the curve of a specimen that dilates goes down." +
                           seeds_note(experiment),
                .panels = {}};
  for (const Kind& kind : kinds(experiment)) {
    add(ratio, curves(kind, "fig06", stress_ratio(), [](const PathPoint& p) { return p.stress.ratio(); }));
    add(volume, curves(kind, "fig07", {"volumetric_strain", {.title = "volumetric strain [%]", .unit = 0.01}},
                       [](const PathPoint& p) { return p.volumetric_strain; }));
  }
  to.push_back(std::move(ratio));
  to.push_back(std::move(volume));
  to.push_back(shear_loops(experiment));
}

} // namespace granum::studies
