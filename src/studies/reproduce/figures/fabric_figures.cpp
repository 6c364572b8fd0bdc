// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include <granum/fabric/estimates.hpp>
#include <granum/fabric/orientation.hpp>

#include "figure_parts.hpp"
#include "studies/paper/paper.hpp"

namespace granum::studies {

namespace {

constexpr double pi = std::numbers::pi;

/// Contacts per solid angle with errors sqrt(n), over polar angle.
plot::Series histogram(const StateRecord& point) {
  plot::Series out{.mark = plot::Mark::both};
  const std::vector<std::size_t> counts(point.polar_counts.begin(), point.polar_counts.end());
  for (const fabric::RoseBin& bin : fabric::readable_rose(counts, 0))
    out.add((bin.low + bin.high) / 2, bin.density, bin.density_error);
  return out;
}

/// E(gamma; a) with a of the same contacts; empty if a is outside of the range of E.
plot::Series fitted(const StateRecord& point) {
  constexpr int steps = 60;
  plot::Series out{.mark = plot::Mark::line};
  const double a = fabric::anisotropy_from_F33(point.fabric(2, 2));
  if (!(std::abs(a) <= 1))
    return out;
  for (int k = 0; k <= steps; ++k) {
    const double angle = pi / 2 * k / steps;
    out.add(angle, fabric::density(angle, a));
  }
  return out;
}

/// The last frozen state before eta falls, or the last of isotropic compression.
const StateRecord* last_up_to_peak(const PathRun& run) {
  const std::vector<const StateRecord*> points = up_to_peak(run);
  return points.empty() ? nullptr : points.back();
}

Panel direction_panel(const Kind& kind) {
  Panel out = panel("fig16_" + kind.key(), kind.title(), {"gamma_rad", {.title = "\u03b3 from the vertical"}},
                    {"E_per_sr", {.title = "E [1/sr]"}});
  out.chart.rose = true;
  out.chart.width = out.chart.height = 300;
  out.chart.legend_below = true;
  for (const PathRun& run : kind.specimen->runs) {
    const bool drawn =
        !run.path || *run.path == stress::ShearPath::txc || *run.path == stress::ShearPath::rtxe;
    const StateRecord* point = drawn ? last_up_to_peak(run) : nullptr;
    if (point == nullptr || point->contacts == 0)
      continue;
    const std::string path(name(run.path));
    plot::Series bars = histogram(*point), line = fitted(*point);
    bars.style = line.style = style_of(run.path);
    bars.colour = line.colour = colour_of(run.path);
    bars.name = run.path ? path + " near its peak" : "isotropic";
    add(out, std::move(line), path + " fitted");
    add(out, std::move(bars), path + " counted");
  }
  return out;
}

/// Error bars on every fifth point only, of paths that lie upon each other on different ones.
constexpr std::size_t bar_stride = 5;
std::size_t first_bar(const PathRun& run) { return 1 + 2 * (style_of(run.path) % 2); }

using ErrorOf = std::optional<double> (*)(const StateRecord&);

Panel microstructure_panel(const Kind& kind, const std::string& stem, const std::string& title,
                           const Quantity& y, const Coordinate& of, ErrorOf error) {
  Panel out =
      panel(stem + "_" + kind.key() + "_" + y.heading, title + ": " + kind.title(), stress_ratio(), y);
  for (const PathRun& run : kind.specimen->runs) {
    if (!run.path)
      continue;
    const std::string path(name(run.path));
    plot::Series past = series_of(run, past_peak(run), eta_of, of);
    past.mark = plot::Mark::marker;
    past.tone = plot::Tone::faint;
    past.name = "";
    add(out, std::move(past), path + " past the peak");
    const std::vector<const StateRecord*> points = from_start(*kind.specimen, run);
    plot::Series line = series_of(run, points, eta_of, of);
    for (std::size_t k = 0; error != nullptr && k < points.size(); ++k)
      line.y_error.push_back(k % bar_stride == first_bar(run) ? error(*points[k]).value_or(0) : 0);
    line.mark = plot::Mark::line;
    add(out, std::move(line), path);
  }
  return out;
}

std::optional<double> coordination(const StateRecord& p) { return p.micro.coordination_number; }
std::optional<double> coordination_error(const StateRecord& p) { return p.coordination_error; }
std::optional<double> mechanical(const StateRecord& p) { return p.micro.mechanical_coordination_number; }
std::optional<double> anisotropy(const StateRecord& p) { return p.micro.fabric_anisotropy; }
std::optional<double> anisotropy_error(const StateRecord& p) { return p.micro.fabric_anisotropy_error; }

} // namespace

void add_direction_figure(std::vector<Figure>& to, const Experiment& experiment) {
  Figure out{
      .name = "Fig. 16",
      .title = "Directions of the contacts",
      .caption =
          "Contact normals per solid angle, by their angle \u03b3 from the vertical. Markers: counts n in "
          "bins of \u03b3, with \u221an as error; the number of bins leaves 25 contacts in the bin around "
          "the "
          "vertical. Lines: the density E(\u03b3; a) = 3(1 + a cos 2\u03b3)/(4\u03c0(3 - a)) with the "
          "anisotropy a of the same contacts. Isotropic contacts have E = 1/(4\u03c0) = 0.080 at every "
          "angle, "
          "a circle." +
          seeds_note(experiment),
      .panels = {}};
  for (const Kind& kind : kinds(experiment))
    add(out, direction_panel(kind));
  to.push_back(std::move(out));
}

void add_microstructure_figures(std::vector<Figure>& to, const Experiment& experiment) {
  int number = 17;
  const std::vector<Kind> all = kinds(experiment);
  for (const contact::LawRow& row : contact::laws()) {
    const contact::Shape contact = row.shape;
    const bool printed = studies::printed(contact, triaxial::Density::dense).has_value();
    const std::string stem = printed ? "fig" + std::to_string(number) : "more";
    Figure out{
        .name = printed ? "Fig. " + std::to_string(number) : "Beyond the paper",
        .title = "Contacts and their directions: " + std::string(name(contact)),
        .caption =
            "C_n is the mean number of contacts of a grain, z* the same for the grains that carry load, a "
            "the "
            "anisotropy of the contacts' directions (positive: more near the vertical). Lines up to the "
            "peak, small dots past it. Error bars on every fifth state: for C_n from the scatter of the "
            "grains' numbers of contacts, for a from that of independent directions." +
            seeds_note(experiment),
        .panels = {}};
    for (const Kind& kind : all)
      if (kind.contact == contact)
        add(out, microstructure_panel(kind, stem, "C_n", {"C_n", {.title = "C_n"}}, coordination,
                                      coordination_error));
    for (const Kind& kind : all)
      if (kind.contact == contact)
        add(out, microstructure_panel(kind, stem, "z*", {"z_star", {.title = "z*"}}, mechanical, nullptr));
    for (const Kind& kind : all)
      if (kind.contact == contact)
        add(out, microstructure_panel(kind, stem, "a", {"a", {.title = "a"}}, anisotropy, anisotropy_error));
    to.push_back(std::move(out));
    ++number;
  }
}

} // namespace granum::studies
