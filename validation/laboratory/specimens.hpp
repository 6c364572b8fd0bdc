// SPDX-License-Identifier: GPL-3.0-or-later
// What was measured, and granum's own packings of the same grains at the same pressures.
#pragma once

#include <granum/contact/power_law.hpp>
#include <granum/effective/state.hpp>

#include "../common.hpp"

namespace laboratory {

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

inline std::vector<Measured> read_measured(const std::string& path, const std::string& specimen) {
  std::vector<Measured> all;
  for (const Entry& row : read_record(path))
    if (const double V_s = row(specimen + "_Vs_m/s"); !std::isnan(V_s))
      all.push_back({row("p_MPa") * 1e6, row(specimen + "_Vp_m/s"), V_s});
  return all;
}

/// A packing of `granum verify`, mean of its seeds.
struct Packing {
  double coordination_number = 0, mechanical_coordination_number = 0;
  double shear_modulus = 0, bulk_modulus = 0; ///< of the network [Pa]
};

/// Of one density ("dense", "loose") at one pressure.
inline Packing packing_at(const std::vector<Entry>& record, const std::string& density, double pressure) {
  std::vector<Entry> seeds;
  for (const Entry& row : record)
    if (row.text("density") == density && std::lround(row("p_Pa")) == std::lround(pressure))
      seeds.push_back(row);
  if (seeds.empty())
    throw std::runtime_error("no " + density + " packing at " + std::to_string(pressure) + " Pa");
  const double share = 1.0 / static_cast<double>(seeds.size());
  Packing mean;
  for (const Entry& row : seeds) {
    mean.coordination_number += share * row("C_n");
    mean.mechanical_coordination_number += share * row("z_star");
    mean.shear_modulus += share * row("G_network_Pa");
    mean.bulk_modulus += share * row("K_network_Pa");
  }
  return mean;
}

} // namespace laboratory
