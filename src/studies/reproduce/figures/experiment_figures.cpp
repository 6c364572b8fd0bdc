// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/reproduce/figures/experiment_figures.hpp"

#include <algorithm>
#include <cmath>

#include "figure_parts.hpp"
#include "studies/reproduce/experiment_findings.hpp"

namespace granum::studies {

namespace {

/// Number of frozen states up to the first peak: all before |eta| is lower than it was.
std::size_t rising(const PathRun& run) {
  const auto falls = [](const StateRecord& a, const StateRecord& b) {
    return std::abs(b.at.stress.ratio()) < std::abs(a.at.stress.ratio());
  };
  const auto last = std::adjacent_find(run.points.begin(), run.points.end(), falls);
  if (!run.path || last == run.points.end())
    return run.points.size();
  return static_cast<std::size_t>(last - run.points.begin()) + 1;
}

std::vector<const StateRecord*> part(const PathRun& run, std::size_t first, std::size_t end) {
  std::vector<const StateRecord*> out;
  for (std::size_t k = first; k < end; ++k)
    out.push_back(&run.points[k]);
  return out;
}

} // namespace

void add(Figure& to, Panel panel) {
  if (!panel.chart.series.empty())
    to.panels.push_back(std::move(panel));
}

std::string Kind::title() const { return std::string(name(contact)) + ", " + std::string(name(density)); }

std::string Kind::key() const {
  std::string text = std::string(name(contact)) + "_" + std::string(name(density));
  std::replace(text.begin(), text.end(), '-', '_');
  return text;
}

std::vector<Kind> kinds(const Experiment& experiment) {
  std::vector<Kind> out;
  for (const ExperimentSpecimen& specimen : experiment.specimens) {
    const bool known = std::any_of(out.begin(), out.end(), [&](const Kind& kind) {
      return kind.contact == specimen.contact && kind.density == specimen.density;
    });
    if (!known)
      out.push_back({.contact = specimen.contact, .density = specimen.density, .specimen = &specimen});
  }
  return out;
}

std::string seeds_note(const Experiment& experiment) {
  const std::size_t seeds = experiment.scene.study.seeds;
  return seeds > 1 ? " Drawn is the first of " + std::to_string(seeds) + " specimens of each kind." : "";
}

std::size_t style_of(const std::optional<stress::ShearPath>& path) {
  const auto& paths = stress::all_shear_paths;
  return path ? static_cast<std::size_t>(std::find(paths.begin(), paths.end(), *path) - paths.begin())
              : paths.size();
}

plot::Colour colour_of(const std::optional<stress::ShearPath>& path) {
  using plot::Colour;
  if (!path)
    return Colour::measured;
  switch (*path) {
  case stress::ShearPath::txc:
    return Colour::txc;
  case stress::ShearPath::rtxc:
    return Colour::rtxc;
  case stress::ShearPath::rtxe:
    return Colour::rtxe;
  case stress::ShearPath::txe:
    break;
  }
  return Colour::txe;
}

std::vector<const StateRecord*> up_to_peak(const PathRun& run) { return part(run, 0, rising(run)); }
std::vector<const StateRecord*> past_peak(const PathRun& run) {
  return part(run, rising(run), run.points.size());
}

std::vector<const StateRecord*> from_start(const ExperimentSpecimen& specimen, const PathRun& run) {
  std::vector<const StateRecord*> out;
  const std::vector<const StateRecord*> rest = up_to_peak(run);
  const PathRun* iso = find_run(specimen, std::nullopt);
  if (run.path && !rest.empty() && iso != nullptr && !iso->points.empty())
    out.push_back(&iso->points.back());
  out.insert(out.end(), rest.begin(), rest.end());
  return out;
}

std::optional<double> eta_of(const StateRecord& point) { return point.at.stress.ratio(); }
std::optional<double> mean_stress_of(const StateRecord& point) { return point.at.stress.mean(); }

plot::Series series_of(const PathRun& run, const std::vector<const StateRecord*>& points, const Coordinate& x,
                       const Coordinate& y) {
  plot::Series out{
      .name = std::string(name(run.path)), .style = style_of(run.path), .colour = colour_of(run.path)};
  for (const StateRecord* point : points) {
    const std::optional<double> across = x(*point), up = y(*point);
    if (across && up)
      out.add(*across, *up);
  }
  return out;
}

std::vector<Figure> experiment_figures(const Experiment& experiment) {
  std::vector<Figure> figures;
  add_path_figures(figures, experiment);
  add_modulus_figures(figures, experiment);
  add_exponent_figure(figures, experiment);
  add_direction_figure(figures, experiment);
  add_microstructure_figures(figures, experiment);
  add_relaxation_figure(figures, experiment);
  std::erase_if(figures, [](const Figure& figure) { return figure.panels.empty(); });
  return figures;
}

} // namespace granum::studies
