// SPDX-License-Identifier: GPL-3.0-or-later
// Glass beads and Ottawa sand of Domenico (1977) beside spheres of glass and quartz, 2 to 34 MPa.
#pragma once

#include <granum/core/numerics.hpp>
#include <granum/effective/relaxation.hpp>
#include <granum/effective/uniform_field.hpp>
#include <granum/inverse/inference.hpp>
#include <granum/plot/chart.hpp>

#include "../common.hpp"
#include "specimens.hpp"

namespace laboratory {

struct Moduli {
  double shear = 0, bulk = 0; ///< [Pa]
};

/// What one estimate says at each pressure.
struct Estimate {
  const char* name;
  std::vector<Moduli> moduli; ///< one a pressure
};

struct Comparison {
  const Grains* grains;
  std::vector<Measured> measured;
  std::vector<Estimate> estimates;

  [[nodiscard]] double density(double n) const { return grains->density * (1 - n); }
  [[nodiscard]] Moduli measured_moduli(std::size_t k, double n = porosity) const {
    return {measured[k].shear_modulus(density(n)), measured[k].bulk_modulus(density(n))};
  }
};

inline Moduli uniform_strain_moduli(const State& state) {
  const auto c = granum::effective::uniform_strain(state).stiffness;
  return {c.G_vh(), c.bulk_modulus()};
}
inline Moduli relaxed_moduli(const State& state, double z) {
  const auto c = granum::effective::relaxed(state, z).stiffness;
  return {c.G_vh(), c.bulk_modulus()};
}

/// The estimates at a porosity; the networks keep the void ratio of their own packings.
inline Comparison compare(const Grains& grains, const std::string& folder, double n = porosity) {
  Comparison c{.grains = &grains,
               .measured = read_measured(folder + "/domenico1977.csv", grains.name),
               .estimates = {{"uniform strain, dense", {}},
                             {"rung 3, dense", {}},
                             {"rung 3, compressed with friction", {}},
                             {"network, dense", {}},
                             {"network, compressed with friction", {}}}};
  const char* states = &grains == &glass ? "/beads_states.csv" : "/quartz_states.csv";
  const std::vector<Entry> packings = read_record(folder + states);
  for (const Measured& m : c.measured) {
    State state = spheres(grains, void_ratio_of(n), m.pressure);
    const Packing dense = packing_at(packings, "dense", m.pressure);
    const Packing loose = packing_at(packings, "loose", m.pressure);
    state.coordination_number = dense.coordination_number;
    c.estimates[0].moduli.push_back(uniform_strain_moduli(state));
    c.estimates[1].moduli.push_back(relaxed_moduli(state, dense.mechanical_coordination_number));
    state.coordination_number = loose.coordination_number;
    c.estimates[2].moduli.push_back(relaxed_moduli(state, loose.mechanical_coordination_number));
    c.estimates[3].moduli.push_back({dense.shear_modulus, dense.bulk_modulus});
    c.estimates[4].moduli.push_back({loose.shear_modulus, loose.bulk_modulus});
  }
  return c;
}

/// |model/measured - 1| of G from a pressure on.
inline Errors misses(const Comparison& c, std::size_t estimate, double from) {
  Errors all;
  for (std::size_t k = 0; k < c.measured.size(); ++k)
    if (c.measured[k].pressure > from)
      all.add(c.estimates[estimate].moduli[k].shear / c.measured_moduli(k).shear - 1);
  return all;
}

/// s of modulus ~ p^s by least squares in logarithms; what was not measured is left out.
inline double exponent_of(const std::vector<Measured>& at, const std::vector<double>& moduli) {
  std::vector<granum::Point> points;
  for (std::size_t k = 0; k < at.size(); ++k)
    if (moduli[k] > 0)
      points.push_back({std::log(at[k].pressure), std::log(moduli[k])});
  return granum::straight_line(points).slope.value;
}

/// What was not measured is a dash.
inline void print_number(double number, int digits) {
  if (std::isnan(number))
    std::printf("      -");
  else
    std::printf(" %6.*f", digits, number);
}

inline void print(const Comparison& c, double Moduli::*modulus, const char* symbol) {
  std::printf("\n%s: %s over that measured, porosity %.2f\n  %-36s", c.grains->name, symbol, porosity,
              "p [MPa]");
  for (const Measured& m : c.measured)
    std::printf(" %6.2f", m.pressure / 1e6);
  std::printf("   s of p^s\n  %-36s", "measured [MPa]");
  std::vector<double> moduli;
  for (std::size_t k = 0; k < c.measured.size(); ++k) {
    moduli.push_back(c.measured_moduli(k).*modulus);
    print_number(moduli.back() / 1e6, 0);
  }
  std::printf("   %.3f", exponent_of(c.measured, moduli));
  for (const Estimate& estimate : c.estimates) {
    std::printf("\n  %-36s", estimate.name);
    std::vector<double> own;
    for (std::size_t k = 0; k < c.measured.size(); ++k) {
      own.push_back(estimate.moduli[k].*modulus);
      print_number(own.back() / moduli[k], 2);
    }
    std::printf("   %.3f", exponent_of(c.measured, own));
  }
  std::printf("\n");
}

inline granum::plot::Chart chart(const Comparison& c, double Moduli::*modulus, const std::string& symbol) {
  namespace plot = granum::plot;
  plot::Chart picture{.title = std::string(c.grains == &glass ? "Dry glass beads" : "Dry Ottawa sand") +
                               ", Domenico (1977)",
                      .x = {.title = "p' [MPa]", .scale = plot::Scale::logarithmic, .unit = 1e6},
                      .y = {.title = symbol + " [MPa]", .scale = plot::Scale::logarithmic, .unit = 1e6}};
  plot::Series points{.name = "measured, porosity 0.36 to 0.40",
                      .mark = plot::Mark::marker,
                      .style = 0,
                      .colour = plot::Colour::measured};
  for (std::size_t k = 0; k < c.measured.size(); ++k)
    points.add(
        c.measured[k].pressure, c.measured_moduli(k).*modulus,
        (c.measured_moduli(k, least_porosity).*modulus - c.measured_moduli(k, most_porosity).*modulus) / 2);
  for (std::size_t k = 0; k < c.estimates.size(); ++k) {
    const bool network = k >= 3;
    plot::Series series{.name = c.estimates[k].name,
                        .mark = network ? plot::Mark::marker : plot::Mark::line,
                        .x = points.x,
                        .style = network ? k - 1 : k + 1,
                        .tone = network ? plot::Tone::hollow : plot::Tone::full};
    for (const Moduli& moduli : c.estimates[k].moduli)
      series.y.push_back(moduli.*modulus);
    picture.series.push_back(std::move(series));
  }
  picture.series.push_back(std::move(points));
  return picture;
}

/// V_s at every other pressure, inferred from that at one: the relative misses for each, the largest
/// printed. The void ratio is that of the porosity at the pressure that is known.
/// \return   all misses
inline Errors foretell(const char* text, const Grains& grains, const std::vector<Measured>& measured,
                       granum::inverse::GrowthRule growth, double n = porosity) {
  namespace inverse = granum::inverse;
  Errors all;
  std::printf("  %-44s", text);
  for (const Measured& known : measured) {
    const State state = spheres(grains, void_ratio_of(n), known.pressure);
    const inverse::Observation one{inverse::Quantity::V_s, {known.V_s, 0.01 * known.V_s}, state};
    const auto answer =
        inverse::infer(std::span(&one, 1), {.grain_density = grains.density, .growth = growth});
    if (!answer.together)
      continue;
    Errors here;
    for (const Measured& other : measured) {
      const State there = spheres(grains, answer.together->void_ratio_at(other.pressure), other.pressure);
      here.add(answer.together->predict(inverse::Quantity::V_s, there).value / other.V_s - 1);
    }
    std::printf(" %5.1f%%", 100 * here.worst());
    all.add(here);
  }
  std::printf("   largest %.1f %%\n", 100 * all.worst());
  return all;
}

} // namespace laboratory
