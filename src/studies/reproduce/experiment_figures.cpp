// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/reproduce/experiment_figures.hpp"

#include <algorithm>
#include <cmath>

#include <granum/io/csv/table.hpp>

#include "experiment_data.hpp"
#include "figure_parts.hpp"

namespace granum::studies {

namespace {

/// Headings of the columns of a panel.
std::vector<plot::CsvColumns> columns(const Panel& panel) {
  std::vector<plot::CsvColumns> out;
  for (std::size_t k = 0; k < panel.keys.size(); ++k) {
    const std::string key = panel.keys[k] + " ";
    const bool errors = !panel.chart.series[k].y_error.empty();
    out.push_back({.x = key + panel.x_heading,
                   .y = key + panel.y_heading,
                   .y_error = errors ? key + "error " + panel.y_heading : ""});
  }
  return out;
}

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

Panel panel(std::string stem, std::string title, const Quantity& x, const Quantity& y) {
  return {.stem = std::move(stem),
          .chart = {.title = std::move(title),
                    .x = x.axis,
                    .y = y.axis,
                    .series = {},
                    .width = 380,
                    .height = 280,
                    .legend_below = true},
          .x_heading = x.heading,
          .y_heading = y.heading,
          .keys = {}};
}

void add(Panel& to, plot::Series series, std::string key) {
  if (series.x.empty())
    return;
  to.chart.series.push_back(std::move(series));
  to.keys.push_back(std::move(key));
}

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
  plot::Series out{.name = std::string(name(run.path)), .x = {}, .y = {}, .style = style_of(run.path)};
  for (const StateRecord* point : points) {
    const std::optional<double> across = x(*point), up = y(*point);
    if (across && up) {
      out.x.push_back(*across);
      out.y.push_back(*up);
    }
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

std::string panel_csv(const Panel& panel) {
  io::CsvContent csv;
  std::size_t rows = 0;
  const std::vector<plot::CsvColumns> headings = columns(panel);
  for (std::size_t k = 0; k < headings.size(); ++k) {
    csv.headings.push_back(headings[k].x);
    csv.headings.push_back(headings[k].y);
    if (!headings[k].y_error.empty())
      csv.headings.push_back(headings[k].y_error);
    rows = std::max(rows, panel.chart.series[k].x.size());
  }
  for (std::size_t row = 0; row < rows; ++row) {
    std::vector<io::CsvCell> cells;
    const auto append = [&](const std::vector<double>& numbers) {
      cells.emplace_back(row < numbers.size() ? numbers[row] : io::empty_cell);
    };
    for (const plot::Series& series : panel.chart.series) {
      append(series.x);
      append(series.y);
      if (!series.y_error.empty())
        append(series.y_error);
    }
    csv.rows.push_back(std::move(cells));
  }
  return io::csv_text(csv);
}

std::string panel_script(const Panel& panel) {
  return plot::gnuplot_script(panel.chart, panel.stem + ".csv", columns(panel), panel.stem + "_gnuplot.svg");
}

} // namespace granum::studies
