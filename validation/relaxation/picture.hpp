// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/effective/relaxation.hpp>
#include <granum/plot/chart.hpp>

#include "../common.hpp"
#include "factors.hpp"

/// The recorded factors beside the library's, as a picture.
namespace relaxation {

/// Networks of isotropic packings at one k_t/k_n, of one shape or of all ("").
template <class Factor>
granum::plot::Series measured_factors(const std::vector<Packing>& packings, const std::string& contact,
                                      double ratio, const Factor& factor) {
  granum::plot::Series series{
      .name = {}, .mark = granum::plot::Mark::marker, .x = {}, .y = {}, .tone = granum::plot::Tone::faint};
  for (const Packing& p : packings)
    for (const Network& n : p.networks)
      if (p.isotropic() && (contact.empty() || p.contact == contact) && std::abs(n.ratio - ratio) < 1e-3) {
        series.x.push_back(p.mechanical_coordination);
        series.y.push_back(factor(p, n));
      }
  return series;
}

/// The library's factor over z*, for k_n ~ f^b.
inline granum::plot::Series
factor_line(double ratio, double b, granum::effective::RelaxationFactor granum::effective::Relaxation::*of) {
  granum::plot::Series series{.name = {}, .mark = granum::plot::Mark::line, .x = {}, .y = {}};
  for (double z = 4; z <= 8.6; z += 0.02) {
    series.x.push_back(z);
    series.y.push_back((granum::effective::relaxation(z, ratio, b).*of).value);
  }
  return series;
}

/// Dots and the line of one colour; the legend names the line.
inline void add_both(granum::plot::Chart& chart, granum::plot::Series dots, granum::plot::Series line,
                     const std::string& name, granum::plot::Colour colour) {
  dots.colour = line.colour = colour;
  dots.style = line.style = chart.series.size() / 2;
  line.name = name;
  chart.series.push_back(std::move(dots));
  chart.series.push_back(std::move(line));
}

/// G by k_t/k_n and K by the shape of the contacts.
inline std::string picture(const std::vector<Packing>& packings) {
  using granum::effective::Relaxation;
  using granum::plot::Colour;
  constexpr double mindlin = 0.919; // k_t/k_n of the specimens
  const granum::plot::Axis z{.title = "mechanical coordination number z*"};
  std::array<granum::plot::Chart, 2> charts{
      {{.title = "G, all shapes (dots); spheres by relaxation() (lines)",
        .x = z,
        .y = {.title = "G / G(uniform strain)"},
        .series = {},
        .legend_below = true},
       {.title = "K, k_t/k_n = 0.92 (dots); by relaxation() (lines)",
        .x = z,
        .y = {.title = "K / K(uniform strain)"},
        .series = {},
        .legend_below = true}}};
  for (const auto& [ratio, name, colour] :
       {std::tuple{mindlin, "k_t/k_n = 0.92", Colour::sphere}, std::tuple{0.1, "0.1", Colour::cone},
        std::tuple{0.0, "0", Colour::flat}})
    add_both(charts[0], measured_factors(packings, "", ratio, Shear::measured),
             factor_line(ratio, 1.0 / 3, &Relaxation::shear), name, colour);
  for (const auto& [contact, b, colour] :
       {std::tuple{"cone", 0.5, Colour::cone}, std::tuple{"sphere", 1.0 / 3, Colour::sphere},
        std::tuple{"flat", 0.0, Colour::flat}, std::tuple{"alpha1.5", 0.4, Colour::power_law}})
    add_both(charts[1], measured_factors(packings, contact, mindlin, Bulk::measured),
             factor_line(mindlin, b, &Relaxation::bulk), contact, colour);
  return granum::plot::svg(charts);
}

} // namespace relaxation
