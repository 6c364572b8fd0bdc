// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iterator>

#include "figure_parts.hpp"
#include "studies/reproduce/experiment_findings.hpp"

namespace granum::studies {

namespace {

using elastic::TransverselyIsotropic;

/// One of the three moduli and its routes.
struct Modulus {
  const char* symbol;
  ModulusOf network;
  ModulusOf probe;
  double (TransverselyIsotropic::*closed)() const;
};

constexpr Modulus moduli[] = {
    {"G_hh", network_G_hh, probe_G_hh, &TransverselyIsotropic::G_hh},
    {"G_hv", network_G_vh, probe_G_hv, &TransverselyIsotropic::G_vh},
    {"G_vh", network_G_vh, probe_G_vh, &TransverselyIsotropic::G_vh},
};

/// Number of the paper's figure; empty for a contact that is not in it.
std::optional<int> figure_number(const Kind& kind) {
  const int first = kind.density == triaxial::Density::dense ? 9 : 12;
  using contact::Shape;
  constexpr Shape in_order[] = {Shape::cone, Shape::sphere, Shape::flat};
  const auto* const found = std::find(std::begin(in_order), std::end(in_order), kind.contact);
  return found != std::end(in_order) ? std::optional(first + static_cast<int>(found - in_order))
                                     : std::nullopt;
}

std::string two_digits(int number) { return (number < 10 ? "0" : "") + std::to_string(number); }

/// Series that many runs have in common are listed in the legend once.
void name_once(plot::Series& series, const Panel& in, const std::string& common) {
  const auto& all = in.chart.series;
  const bool listed = std::any_of(all.begin(), all.end(), [&](const auto& s) { return s.name == common; });
  series.name = listed ? "" : common;
}

void add_closed_form(Panel& to, const ExperimentSpecimen& specimen, const PathRun& run, const Coordinate& x,
                     const Modulus& modulus, TransverselyIsotropic ClosedForms::*estimate,
                     const std::string& legend, std::size_t style) {
  plot::Series line = series_of(run, from_start(specimen, run), x, [&](const StateRecord& point) {
    return point.closed ? std::optional((((*point.closed).*estimate).*modulus.closed)()) : std::nullopt;
  });
  name_once(line, to, legend);
  line.mark = plot::Mark::line;
  line.tone = plot::Tone::grey;
  line.style = style; // of dashes
  add(to, std::move(line), std::string(name(run.path)) + " " + legend);
}

/// One modulus of a specimen on all paths; isotropic compression only if x differs between its states.
Panel modulus_panel(const Kind& kind, const std::string& stem, const Modulus& modulus, const Quantity& x,
                    const Coordinate& across, bool with_iso) {
  const std::string symbol = modulus.symbol;
  Panel out = panel(stem, symbol + ": " + kind.title(), x,
                    {symbol + "_Pa", {.title = symbol + " [MPa]", .unit = 1e6}});
  const std::vector<PathRun>& runs = kind.specimen->runs;
  const auto each_run = [&](const auto& draw) {
    for (const PathRun& run : runs)
      if (run.path || with_iso)
        draw(run, std::string(name(run.path)));
  };
  each_run([&](const PathRun& run, const std::string&) {
    add_closed_form(out, *kind.specimen, run, across, modulus, &ClosedForms::uniform_strain, "uniform strain",
                    0);
    add_closed_form(out, *kind.specimen, run, across, modulus, &ClosedForms::relaxed, "relaxed (closed form)",
                    1);
  });
  each_run([&](const PathRun& run, const std::string& path) {
    plot::Series past = series_of(run, past_peak(run), across, modulus.network);
    name_once(past, out, "past the peak");
    past.mark = plot::Mark::marker;
    past.tone = plot::Tone::faint;
    add(out, std::move(past), path + " past the peak");
  });
  each_run([&](const PathRun& run, const std::string& path) {
    plot::Series line = series_of(run, from_start(*kind.specimen, run), across, modulus.network);
    line.mark = plot::Mark::line;
    add(out, std::move(line), path + " network");
  });
  each_run([&](const PathRun& run, const std::string& path) {
    plot::Series markers = series_of(run, up_to_peak(run), across, modulus.probe);
    name_once(markers, out, "cyclic shear");
    markers.mark = plot::Mark::marker;
    add(out, std::move(markers), path + " cyclic shear");
  });
  return out;
}

Figure modulus_figure(const Kind& kind, const std::string& stem, const std::string& seeds) {
  Figure out{
      .name = "Beyond the paper",
      .title = "Shear moduli of the specimen " + kind.title(),
      .caption =
          "Lines: the relaxed contact network of each frozen state, up to the peak; small dots: the same "
          "past the peak. Markers: cyclic shear of the frozen specimen. Grey: closed forms from C_n, "
          "void ratio, fabric and stress, full line under uniform strain, dashed line relaxed with z*. A "
          "network has one modulus G_hv = G_vh, the mean over both vertical planes; cyclic shear measures "
          "both, in one of the planes." +
          seeds,
      .panels = {}};
  for (const Modulus& modulus : moduli) {
    const std::string begin = stem + "_" + kind.key() + "_" + modulus.symbol;
    add(out, modulus_panel(kind, begin + "_eta", modulus, stress_ratio(), eta_of, false));
    add(out, modulus_panel(kind, begin + "_p", modulus, mean_stress(), mean_stress_of, true));
  }
  return out;
}

} // namespace

void add_modulus_figures(std::vector<Figure>& to, const Experiment& experiment) {
  const std::string seeds = seeds_note(experiment);
  std::vector<Figure> printed, further;
  for (const Kind& kind : kinds(experiment))
    if (const std::optional<int> number = figure_number(kind)) {
      printed.push_back(modulus_figure(kind, "fig" + two_digits(*number), seeds));
      printed.back().name = "Fig. " + std::to_string(*number);
    } else {
      further.push_back(modulus_figure(kind, "more", seeds));
    }
  // In the order of their numbers: dense before loose.
  std::sort(printed.begin(), printed.end(), [](const Figure& a, const Figure& b) {
    return std::pair(a.name.size(), a.name) < std::pair(b.name.size(), b.name);
  });
  for (std::vector<Figure>* figures : {&printed, &further})
    std::move(figures->begin(), figures->end(), std::back_inserter(to));
}

} // namespace granum::studies
