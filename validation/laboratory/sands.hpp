// SPDX-License-Identifier: GPL-3.0-or-later
// Published laws of measured sands at 50 to 500 kPa beside spheres and cones of quartz, whose contacts follow
// from the void ratio by the contact prior.
#pragma once

#include <granum/effective/contact_prior.hpp>
#include <granum/effective/relaxation.hpp>
#include <granum/plot/chart.hpp>
#include <granum/sands/known_sands.hpp>

#include "../common.hpp"
#include "specimens.hpp"

namespace laboratory {

/// G of the laws whose tests reach that state [Pa].
inline Errors measured_range(double void_ratio, double pressure) {
  Errors range;
  for (const granum::sands::MeasuredLaw& law : granum::sands::measured_laws()) {
    const granum::sands::TestedRange& tested = law.tested;
    if (void_ratio < tested.void_ratio_low || void_ratio > tested.void_ratio_high ||
        pressure < tested.stress_low || pressure > tested.stress_high)
      continue;
    range.add(
        granum::sands::shear_modulus(law, {.void_ratio = void_ratio, .mean_stress = pressure}).shear_modulus);
  }
  return range;
}

/// Quartz grains that touch as spheres or as cones of the default slope.
inline State grains_of_sand(bool cones, double void_ratio, double pressure) {
  State state = spheres(quartz, void_ratio, pressure);
  if (cones)
    state.law = granum::contact::PowerLaw::cone(quartz.material, 0.4);
  return state;
}

inline double relaxed_shear_modulus(const State& state, const granum::effective::ContactCounts& counts) {
  const double z = counts.mechanical_coordination_number;
  return granum::effective::relaxed(granum::effective::with_contacts(state, z, counts.rattler_fraction), z)
      .stiffness.G_vh();
}

/// G of rung 3 from the loosest to the densest packing of that void ratio.
inline Errors model_range(bool cones, double void_ratio, double pressure) {
  const State state = grains_of_sand(cones, void_ratio, pressure);
  const granum::effective::ContactPrior prior = granum::effective::contact_prior(state);
  Errors range;
  range.add(relaxed_shear_modulus(state, prior.loosest));
  range.add(relaxed_shear_modulus(state, prior.densest));
  return range;
}

/// s of G ~ p^s between two pressures, of one packing that is half way between loosest and densest at the
/// first; with its contacts growing, or frozen.
inline double exponent(bool cones, double void_ratio, double from, double to, bool growing) {
  const State state = grains_of_sand(cones, void_ratio, from);
  const granum::effective::ContactCounts counts = granum::effective::contact_prior(state).middle;
  State there = grains_of_sand(cones, void_ratio, to);
  granum::effective::ContactCounts counts_there = counts;
  if (growing) {
    const auto carried = granum::effective::carried_contacts(state, counts, to);
    there.void_ratio = carried.void_ratio;
    counts_there = carried.counts;
  }
  return std::log(relaxed_shear_modulus(there, counts_there) / relaxed_shear_modulus(state, counts)) /
         std::log(to / from);
}

inline constexpr double lowest_stress = 50e3, highest_stress = 500e3;

inline void print_sands() {
  std::printf("\nsands: G [MPa] at 100 kPa, and s of G ~ p^s from 50 to 500 kPa\n"
              "  %-5s %16s %19s %19s | s: %11s %17s %17s\n",
              "e", "measured", "spheres / measured", "cones / measured", "measured", "spheres", "cones");
  for (const double e : {0.55, 0.60, 0.65, 0.70, 0.75, 0.80}) {
    const Errors sand = measured_range(e, 100e3);
    const Errors sphere = model_range(false, e, 100e3), cone = model_range(true, e, 100e3);
    const double middle = std::sqrt(sand.lowest() * sand.highest());
    Errors s;
    for (const granum::sands::MeasuredLaw& law : granum::sands::measured_laws()) {
      const auto G = [&](double p) {
        return granum::sands::shear_modulus(law, {.void_ratio = e, .mean_stress = p}).shear_modulus;
      };
      s.add(std::log(G(highest_stress) / G(lowest_stress)) / std::log(highest_stress / lowest_stress));
    }
    const auto s_of = [&](bool cones, bool growing) {
      return exponent(cones, e, lowest_stress, highest_stress, growing);
    };
    std::printf("  %-5.2f %5.0f to %-4.0f (%d) %8.2f to %-8.2f %8.2f to %-8.2f | %6.2f to %.2f"
                " %8.2f (frozen %.2f) %5.2f (frozen %.2f)\n",
                e, sand.lowest() / 1e6, sand.highest() / 1e6, sand.count(), sphere.lowest() / middle,
                sphere.highest() / middle, cone.lowest() / middle, cone.highest() / middle, s.lowest(),
                s.highest(), s_of(false, true), s_of(false, false), s_of(true, true), s_of(true, false));
  }
}

/// Bands over the pressure at one void ratio: lowest and highest as lines of one style.
inline granum::plot::Chart sand_chart(double void_ratio) {
  namespace plot = granum::plot;
  plot::Chart picture{.title = "Sands and packings of quartz grains, e = 0." +
                               std::to_string(std::lround(100 * void_ratio)),
                      .x = {.title = "p' [kPa]", .scale = plot::Scale::logarithmic, .unit = 1e3},
                      .y = {.title = "G [MPa]", .scale = plot::Scale::logarithmic, .unit = 1e6}};
  struct Band {
    const char* name;
    plot::Colour colour;
    Errors (*range_at)(double void_ratio, double pressure);
  };
  const Band bands[] = {{"measured sands, lowest and highest law", plot::Colour::measured, measured_range},
                        {"spheres, loosest and densest", plot::Colour::sphere,
                         [](double e, double p) { return model_range(false, e, p); }},
                        {"cones, loosest and densest", plot::Colour::cone,
                         [](double e, double p) { return model_range(true, e, p); }}};
  for (std::size_t style = 0; style < std::size(bands); ++style) {
    const auto& [name, colour, range_at] = bands[style];
    plot::Series low{.name = name, .mark = plot::Mark::line, .style = style, .colour = colour};
    plot::Series high = low;
    high.name.clear();
    for (int k = 0; k <= 20; ++k) {
      const double p = lowest_stress * std::pow(highest_stress / lowest_stress, k / 20.0) * (1 - 1e-12);
      const Errors range = range_at(void_ratio, std::max(p, lowest_stress));
      low.add(p, range.lowest());
      high.add(p, range.highest());
    }
    picture.series.push_back(std::move(low));
    picture.series.push_back(std::move(high));
  }
  return picture;
}

} // namespace laboratory
