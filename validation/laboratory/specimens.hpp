// SPDX-License-Identifier: GPL-3.0-or-later
// What was measured, and granum's own packings of the same grains at the same pressures.
#pragma once

#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include <granum/contact/power_law.hpp>
#include <granum/effective/state.hpp>
#include <granum/io/csv/table.hpp>

namespace laboratory {

using granum::Dimension;
using granum::effective::State;

/// Grains as they are taken to be; none of the numbers is fitted.
struct Grains {
  const char* name;
  granum::contact::GrainMaterial material;
  double density; ///< of the solid [kg/m3]
  double radius;  ///< without influence on moduli [m]
};
inline constexpr Grains glass{"beads", {.shear_modulus = 29e9, .poisson_ratio = 0.2}, 2480, 0.05e-3};
inline constexpr Grains quartz{"sand", {.shear_modulus = 44e9, .poisson_ratio = 0.08}, 2650, 0.1e-3};

/// The porosity that the source does not state, and how far it may be off.
inline constexpr double porosity = 0.38, least_porosity = 0.36, most_porosity = 0.40;
inline double void_ratio_of(double n) { return n / (1 - n); }

/// Spheres of these grains at an isotropic stress [Pa], without their contacts.
inline State spheres(const Grains& grains, double void_ratio, double pressure) {
  return {.law = granum::contact::PowerLaw::sphere(grains.material, grains.radius),
          .tangential_ratio = granum::contact::mindlin_stiffness_ratio(grains.material.poisson_ratio),
          .radius = grains.radius,
          .void_ratio = void_ratio,
          .coordination_number = 6, // whoever asks puts in his own
          .stress_v = pressure,
          .stress_h = pressure};
}

/// Speeds at one pressure; NaN where one was not measured.
struct Measured {
  double pressure = 0; ///< [Pa]
  double V_p = 0;      ///< [m/s]
  double V_s = 0;      ///< [m/s]

  [[nodiscard]] double shear_modulus(double density) const { return density * V_s * V_s; }
  [[nodiscard]] double bulk_modulus(double density) const {
    return density * (V_p * V_p - 4 * V_s * V_s / 3);
  }
};

inline double number(const std::string& field) { return field.empty() ? State::unset : std::stod(field); }

inline std::vector<Measured> read_measured(const std::string& path, const std::string& specimen) {
  const granum::io::CsvTable table = granum::io::read_csv(path);
  const std::size_t p = table.column("p", Dimension::pressure).index;
  const std::size_t V_p = table.column(specimen + "_Vp", Dimension::speed).index;
  const std::size_t V_s = table.column(specimen + "_Vs", Dimension::speed).index;
  std::vector<Measured> all;
  for (std::size_t k = 0; k < table.row_count(); ++k) {
    const std::vector<std::string>& fields = table.fields(k);
    const Measured row{number(fields[p]) * 1e6, number(fields[V_p]), number(fields[V_s])};
    if (!std::isnan(row.V_s))
      all.push_back(row);
  }
  return all;
}

/// A packing of `granum verify`, mean of its seeds.
struct Packing {
  double void_ratio = 0;
  double coordination_number = 0;
  double mechanical_coordination_number = 0;
  double shear_modulus = 0; ///< of the network [Pa]
  double bulk_modulus = 0;  ///< of the network [Pa]
};

/// By density ("dense", "loose") and pressure in Pa, rounded.
using Packings = std::map<std::pair<std::string, long>, Packing>;

inline Packings read_packings(const std::string& path) {
  const granum::io::CsvTable table = granum::io::read_csv(path);
  const auto pure = [&](const char* name) { return table.numbers(name, Dimension::dimensionless); };
  const auto pressure = table.numbers("p", Dimension::pressure);
  const auto G = table.numbers("G_network", Dimension::pressure);
  const auto K = table.numbers("K_network", Dimension::pressure);
  const auto e = pure("e"), C_n = pure("C_n"), z = pure("z_star");
  std::map<std::pair<std::string, long>, int> seeds;
  for (std::size_t k = 0; k < table.row_count(); ++k)
    ++seeds[{table.fields(k)[1], std::lround(pressure[k])}];
  Packings all;
  for (std::size_t k = 0; k < table.row_count(); ++k) {
    const std::pair key(table.fields(k)[1], std::lround(pressure[k]));
    const double share = 1.0 / seeds[key];
    Packing& mean = all[key];
    mean.void_ratio += share * e[k];
    mean.coordination_number += share * C_n[k];
    mean.mechanical_coordination_number += share * z[k];
    mean.shear_modulus += share * G[k];
    mean.bulk_modulus += share * K[k];
  }
  return all;
}

inline const Packing& packing_at(const Packings& all, const std::string& density, double pressure) {
  const auto found = all.find({density, std::lround(pressure)});
  if (found == all.end())
    throw std::runtime_error("no " + density + " packing at " + std::to_string(pressure) + " Pa");
  return found->second;
}

} // namespace laboratory
