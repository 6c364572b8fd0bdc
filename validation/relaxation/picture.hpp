// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/effective/relaxation.hpp>
#include <granum/plot/chart.hpp>

#include "../common.hpp"
#include "factors.hpp"

/// The recorded factors beside the library's, as a picture.
namespace relaxation {

/// G by k_t/k_n and K by the shape of contacts: networks of isotropic packings, and the library for
/// k_n ~ f^b.
inline std::string picture(const std::vector<Packing>& packings) {
  using granum::effective::Relaxation;
  using granum::plot::Colour;
  const granum::plot::Axis z{.title = "mechanical coordination number z*"};
  std::array<granum::plot::Chart, 2> charts{
      {{.title = "G, all shapes (dots); spheres by relaxation() (lines)",
        .x = z,
        .y = {.title = "G / G(uniform strain)"},
        .legend_below = true},
       {.title = "K, k_t/k_n = 0.92 (dots); by relaxation() (lines)",
        .x = z,
        .y = {.title = "K / K(uniform strain)"},
        .legend_below = true}}};
  // Dots, of one shape or of all (""), and the line of one colour; the legend names the line.
  const auto add = [&](granum::plot::Chart& chart, const std::string& contact, double ratio, double b,
                       const std::string& name, Colour colour) {
    const bool of_G = &chart == &charts[0];
    granum::plot::Series dots{.mark = granum::plot::Mark::marker, .tone = granum::plot::Tone::faint},
        line{.name = name, .mark = granum::plot::Mark::line};
    dots.colour = line.colour = colour;
    dots.style = line.style = chart.series.size() / 2;
    for (const Packing& p : packings)
      for (const Network& n : p.networks)
        if (p.isotropic() && (contact.empty() || p.contact == contact) && std::abs(n.ratio - ratio) < 1e-3)
          dots.add(p.mechanical_coordination, of_G ? Shear::measured(p, n) : Bulk::measured(p, n));
    for (double at = 4; at <= 8.6; at += 0.02) {
      const Relaxation factors = granum::effective::relaxation(at, ratio, b);
      line.add(at, (of_G ? factors.shear : factors.bulk).value);
    }
    chart.series.push_back(std::move(dots));
    chart.series.push_back(std::move(line));
  };
  constexpr double mindlin = 0.919; // k_t/k_n of the specimens
  add(charts[0], "", mindlin, 1.0 / 3, "k_t/k_n = 0.92", Colour::sphere);
  add(charts[0], "", 0.1, 1.0 / 3, "0.1", Colour::cone);
  add(charts[0], "", 0.0, 1.0 / 3, "0", Colour::flat);
  add(charts[1], "cone", mindlin, 0.5, "cone", Colour::cone);
  add(charts[1], "sphere", mindlin, 1.0 / 3, "sphere", Colour::sphere);
  add(charts[1], "flat", mindlin, 0.0, "flat", Colour::flat);
  add(charts[1], "alpha1.5", mindlin, 0.4, "alpha1.5", Colour::power_law);
  return granum::plot::svg(charts);
}

} // namespace relaxation
