// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/contact/power_law.hpp>
#include <granum/effective/contact_prior.hpp>
#include <granum/plot/chart.hpp>

#include "../common.hpp"
#include "calibration.hpp"
#include "effective/contact_prior_coefficients.hpp"

/// The recorded contacts beside those of the prior, as a picture.
namespace contact_prior {

using granum::plot::Colour;
using granum::plot::Mark;
using granum::plot::Series;
using granum::plot::Tone;

/// The range of the prior for spheres at one pressure, against the void ratio without pressure.
inline std::array<Series, 2> range_lines(double pressure, const std::string& name, Colour colour) {
  Series densest{.name = name, .mark = Mark::line, .style = 0, .colour = colour};
  Series loosest = densest;
  loosest.name.clear();
  for (double e = 0.55; e < 0.9; e += 0.005) {
    granum::effective::State state{
        .law = granum::contact::PowerLaw::sphere({.shear_modulus = 30e9, .poisson_ratio = 0.15}, 0.5e-3),
        .radius = 0.5e-3,
        .void_ratio = e,
        .stress_v = pressure,
        .stress_h = pressure};
    const double overlap = granum::effective::contact_prior(state).relative_overlap;
    state.void_ratio = (1 + e) / (1 + overlap * kernel::contact_coefficients[3]) - 1;
    const granum::effective::ContactPrior prior = granum::effective::contact_prior(state);
    densest.add(e, prior.densest.mechanical_coordination_number);
    loosest.add(e, prior.loosest.mechanical_coordination_number);
  }
  return {densest, loosest};
}

/// Recorded packings of spheres at one pressure: made from a gas or without friction, or opened a little
/// first.
inline Series recorded(const std::vector<Packing>& packings, double pressure, bool opened,
                       const std::string& name, Colour colour) {
  Series series{.name = name,
                .mark = Mark::marker,
                .style = opened ? 2 : 1,
                .tone = opened ? Tone::hollow : Tone::full,
                .colour = colour};
  for (const Packing& p : packings) {
    const bool from_gas = p.preparation.starts_with("gas") || p.preparation == "dense";
    if (p.contact != "sphere" || p.pressure != pressure || from_gas == opened)
      continue;
    series.add(rigid<double>(p, kernel::contact_coefficients), p.mechanical_coordination);
  }
  return series;
}

/// z* over e, and z* of each recipe by the prior beside that of its packing.
inline std::string picture(const std::vector<Packing>& packings) {
  std::array<granum::plot::Chart, 2> charts{{{.title = "Spheres: range of the prior (lines) and packings",
                                              .x = {.title = "void ratio e without pressure"},
                                              .y = {.title = "mechanical coordination number z*"},
                                              .legend_below = true},
                                             {.title = "z* with the recipe known",
                                              .x = {.title = "z* by the prior"},
                                              .y = {.title = "z* of the packing"},
                                              .legend_below = true}}};
  for (const auto& [pressure, name, colour] :
       {std::tuple{10e3, "10 kPa", Colour::sphere}, std::tuple{1e6, "1 MPa", Colour::cone}}) {
    const std::string at = std::string(", ") + name;
    for (Series& line : range_lines(pressure, "densest and loosest" + at, colour))
      charts[0].series.push_back(std::move(line));
    charts[0].series.push_back(
        recorded(packings, pressure, false, "from a gas or without friction" + at, colour));
    charts[0].series.push_back(recorded(packings, pressure, true, "opened, then with friction" + at, colour));
  }
  charts[1].series.push_back(
      {.name = "equal", .mark = Mark::line, .x = {3.9, 7.1}, .y = {3.9, 7.1}, .tone = Tone::grey});
  for (const auto& [contact, colour] :
       {std::pair{"cone", Colour::cone}, std::pair{"sphere", Colour::sphere}, std::pair{"flat", Colour::flat},
        std::pair{"alpha1.5", Colour::power_law}}) {
    Series series{.name = contact, .mark = Mark::marker, .tone = Tone::faint, .colour = colour};
    for (const Packing& p : packings)
      if (p.contact == contact)
        series.add(by_recipe<double>(p, kernel::contact_coefficients), p.mechanical_coordination);
    charts[1].series.push_back(std::move(series));
  }
  return granum::plot::svg(charts);
}

} // namespace contact_prior
