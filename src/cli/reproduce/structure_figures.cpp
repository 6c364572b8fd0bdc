// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of exponents, contacts and their directions, and of the relaxation of all frozen states.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "studies/paper/paper.hpp"
#include "studies/reproduce/experiment_findings.hpp"
#include <fmt/format.h>
#include <granum/fabric/estimates.hpp>
#include <granum/fabric/orientation.hpp>

#include "cli/verify/compression.hpp"
#include "figures.hpp"

namespace granum::cli {

namespace {

using plot::Mark;
using plot::Tone;

// ---- exponents

/// s of one modulus, ours or the printed one, shifted along the axis so that equal values do not hide one
/// another.
plot::Series exponents(const Experiment& experiment, const std::vector<studies::Cell>& table,
                       triaxial::Density density, const std::string& modulus, bool paper) {
  const bool horizontal = modulus == "G_hh";
  plot::Series out{.name = modulus + (paper ? ", paper" : ", granum"),
                   .mark = Mark::marker,
                   .style = horizontal ? 0 : 1,
                   .tone = paper ? Tone::hollow : Tone::full,
                   .colour = horizontal ? plot::Colour::horizontal : plot::Colour::vertical};
  for (const studies::Cell& cell : table)
    if (cell.density == density && cell.quantity == "s of " + modulus && (!paper || cell.printed)) {
      const double x = contact_exponent(experiment.scene, cell.contact) + (horizontal ? -0.008 : 0.008);
      if (paper)
        out.add(x, *cell.printed);
      else
        out.add(x, cell.ours.value,
                cell.ours.standard_error.value_or(std::numeric_limits<double>::quiet_NaN()));
    }
  return out;
}

Figure exponent_figure(const Experiment& experiment) {
  Figure out{.name = "Fig. 15",
             .title = "Exponents s by contact geometry and density",
             .caption =
                 "s of G ~ p^s, from the fit of the paper's Eq. (1) to all states with |\u03b7| \u2264 "
                 "0.6, with its standard error; hollow markers: values of the paper. The line is the "
                 "exponent of the single contact. Markers of G_hh are drawn slightly to the left, "
                 "those of G_hv to the right."};
  const std::vector<studies::Cell> table = table_5(experiment);
  for (const triaxial::Density density : experiment.scene.study.densities) {
    Panel panel =
        studies::panel(fmt::format("fig15_{}", studies::name(density)), std::string(studies::name(density)),
                       {"contact_exponent", {.title = "1/(1+\u03b1): flat 0, sphere 1/3, cone 1/2"}},
                       {"s", {.title = "s = m + n"}});
    for (const std::string modulus : {"G_hh", "G_hv"}) {
      add(panel, exponents(experiment, table, density, modulus, true), modulus + " paper");
      add(panel, exponents(experiment, table, density, modulus, false), modulus + " granum");
    }
    if (!panel.chart.series.empty())
      add(panel,
          {.name = "s = 1/(1+\u03b1)",
           .mark = Mark::line,
           .x = {0, 0.5},
           .y = {0, 0.5},
           .style = 0,
           .tone = Tone::grey},
          "contact law");
    add(out, std::move(panel));
  }
  return out;
}

// ---- directions

/// Contacts per solid angle with errors sqrt(n), over polar angle.
void set_histogram(plot::Series& to, const StateRecord& point) {
  const std::vector<std::size_t> counts(point.polar_counts.begin(), point.polar_counts.end());
  for (const fabric::RoseBin& bin : fabric::readable_rose(counts, 0))
    to.add((bin.low + bin.high) / 2, bin.density, bin.density_error);
}

/// E(gamma; a) with a of the same contacts; nothing if a is outside of the range of E.
void set_fitted(plot::Series& to, const StateRecord& point) {
  constexpr int steps = 60;
  const double a = fabric::anisotropy_from_F33(point.fabric(2, 2));
  for (int k = 0; std::abs(a) <= 1 && k <= steps; ++k) {
    const double angle = std::numbers::pi / 2 * k / steps;
    to.add(angle, fabric::density(angle, a));
  }
}

Figure direction_figure(const Experiment& experiment) {
  Figure out = figure_of(
      experiment, "Fig. 16", "Directions of the contacts",
      "Contact normals per solid angle, by their angle \u03b3 from the vertical. Markers: counts n in bins "
      "of \u03b3, with \u221an as error; the number of bins leaves 25 contacts in the bin around the "
      "vertical. Lines: the density E(\u03b3; a) = 3(1 + a cos 2\u03b3)/(4\u03c0(3 - a)) with the anisotropy "
      "a of the same contacts. Isotropic contacts have E = 1/(4\u03c0) = 0.080 at every angle, a circle.");
  for (const Kind& kind : kinds(experiment)) {
    Panel rose = studies::panel("fig16_" + kind.key(), kind.title(),
                                {"gamma_rad", {.title = "\u03b3 from the vertical"}},
                                {"E_per_sr", {.title = "E [1/sr]"}});
    rose.chart.rose = true;
    rose.chart.width = rose.chart.height = 300;
    for (const PathRun& run : kind.specimen->runs) {
      using enum stress::ShearPath;
      const Points points = up_to_peak(run); // its last state is drawn
      if ((run.path && *run.path != txc && *run.path != rtxe) || points.empty() ||
          points.back()->contacts == 0)
        continue;
      const std::string path(studies::name(run.path));
      plot::Series line = series_of(run, {}, {}, {}), bars = series_of(run, {}, {}, {}, Mark::both);
      line.name.clear();
      set_fitted(line, *points.back());
      add(rose, std::move(line), path + " fitted");
      bars.name = run.path ? path + " near its peak" : "isotropic";
      set_histogram(bars, *points.back());
      add(rose, std::move(bars), path + " counted");
    }
    add(out, std::move(rose));
  }
  return out;
}

// ---- microstructure

/// A quantity of the microstructure, and its error where that is known.
struct Microstructure {
  const char *heading, *title;
  double (*of)(const StateRecord&);
  double (*error)(const StateRecord&);
};
constexpr Microstructure quantities[] = {
    {"C_n", "C_n", [](const StateRecord& p) { return p.micro.coordination_number; },
     [](const StateRecord& p) { return p.coordination_error; }},
    {"z_star", "z*", [](const StateRecord& p) { return p.micro.mechanical_coordination_number; }, nullptr},
    {"a", "a", [](const StateRecord& p) { return p.micro.fabric_anisotropy; },
     [](const StateRecord& p) { return p.micro.fabric_anisotropy_error; }}};

Panel microstructure_panel(const Kind& kind, const std::string& stem, const Microstructure& quantity) {
  // Error bars on every fifth point only, of paths that lie upon each other on different ones.
  constexpr std::size_t bar_stride = 5;
  const Coordinate of = [&quantity](const StateRecord& p) { return std::optional(quantity.of(p)); };
  Panel out = studies::panel(fmt::format("{}_{}_{}", stem, kind.key(), quantity.heading),
                             fmt::format("{}: {}", quantity.title, kind.title()), stress_ratio(),
                             {quantity.heading, {.title = quantity.title}});
  for (const PathRun& run : kind.specimen->runs) {
    if (!run.path)
      continue;
    plot::Series past = series_of(run, past_peak(run), eta_of, of, Mark::marker, Tone::faint);
    past.name.clear();
    add(out, std::move(past), fmt::format("{} past the peak", studies::name(run.path)));
    const Points points = from_start(*kind.specimen, run);
    plot::Series line = series_of(run, points, eta_of, of);
    for (std::size_t k = 0; quantity.error != nullptr && k < points.size(); ++k)
      line.y_error.push_back(k % bar_stride == 1 + 2 * (line.style.value() % 2) ? quantity.error(*points[k])
                                                                                : 0);
    add(out, std::move(line), std::string(studies::name(run.path)));
  }
  return out;
}

void add_microstructure_figures(std::vector<Figure>& to, const Experiment& experiment) {
  int number = 17;
  for (const contact::LawRow& row : contact::laws()) {
    const bool printed = studies::printed(row.shape, triaxial::Density::dense).has_value();
    Figure out = figure_of(
        experiment, printed ? fmt::format("Fig. {}", number) : "Beyond the paper",
        fmt::format("Contacts and their directions: {}", name(row.shape)),
        "C_n is the mean number of contacts of a grain, z* the same for the grains that carry load, a the "
        "anisotropy of the contacts' directions (positive: more near the vertical). Lines up to the peak, "
        "small dots past it. Error bars on every fifth state: for C_n from the scatter of the grains' "
        "numbers of contacts, for a from that of independent directions.");
    for (const Microstructure& quantity : quantities)
      for (const Kind& kind : kinds(experiment))
        if (kind.contact == row.shape)
          add(out, microstructure_panel(kind, printed ? fmt::format("fig{}", number) : "more", quantity));
    to.push_back(std::move(out));
    ++number;
  }
}

// ---- relaxation

/// All states of all seeds of a contact and density.
plot::Series relaxed_states(const Experiment& experiment, const Kind& kind) {
  plot::Series out{.name = kind.title(),
                   .mark = Mark::marker,
                   .style = kind.density == triaxial::Density::dense ? 0 : 1,
                   .tone = Tone::faint,
                   .colour = colour_of(kind.contact)};
  for (const ExperimentSpecimen& specimen : experiment.specimens)
    if (specimen.contact == kind.contact && specimen.density == kind.density)
      for (const PathRun& run : specimen.runs)
        for (const StateRecord& point : run.points)
          if (const std::optional<double> ratio = network_over_uniform_strain(point))
            out.add(point.micro.mechanical_coordination_number, *ratio);
  return out;
}

Figure relaxation_figure(const Experiment& experiment) {
  Figure out{.name = "Beyond the paper",
             .title = "How much softer than uniform strain",
             .caption =
                 "The shear modulus of the network over that of uniform strain in closed form, isotropic "
                 "parts of both, for every frozen state of every path and seed, also past the peak. It "
                 "depends almost only on the number of contacts of grains that carry load. Lines: the "
                 "closed form calibrated on other specimens (validation/relaxation)."};
  Panel all =
      studies::panel("more_relaxation", "All frozen states",
                     {"z_star", {.title = "z* (contacts of a grain, rattlers left out)"}},
                     {"G_over_G_uniform_strain", {.title = "G of the network / G under uniform strain"}});
  all.chart.width = 520;
  all.chart.height = 380;
  std::vector<double> found;
  for (const Kind& kind : kinds(experiment)) {
    plot::Series series = relaxed_states(experiment, kind);
    found.insert(found.end(), series.x.begin(), series.x.end());
    add(all, std::move(series), kind.key());
  }
  if (found.empty())
    return out;
  const auto [low, high] = std::ranges::minmax(found);
  for (const contact::Shape contact : experiment.scene.study.contacts) {
    plot::Series line = relaxation_curve(experiment.scene, contact, low, high, 80);
    line.name = fmt::format("closed form, {}", name(contact));
    line.style = 0;
    line.colour = colour_of(contact);
    add(all, std::move(line), fmt::format("closed form {}", name(contact)));
  }
  add(out, std::move(all));
  return out;
}

} // namespace

void add_structure_figures(std::vector<Figure>& to, const Experiment& experiment) {
  to.push_back(exponent_figure(experiment));
  to.push_back(direction_figure(experiment));
  add_microstructure_figures(to, experiment);
  to.push_back(relaxation_figure(experiment));
}

} // namespace granum::cli
