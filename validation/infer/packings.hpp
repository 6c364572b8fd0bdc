// SPDX-License-Identifier: GPL-3.0-or-later
// Reads states.csv: packings whose contacts and moduli are known, which no fit has seen.
#pragma once

#include <granum/contact/power_law.hpp>
#include <granum/contact/rough_sphere.hpp>
#include <granum/effective/contact_prior.hpp>
#include <granum/effective/state.hpp>

#include "../common.hpp"

namespace infer_packings {

using granum::effective::State;

/// As in packings.toml.
inline constexpr granum::contact::GrainMaterial quartz{.shear_modulus = 44e9, .poisson_ratio = 0.08};
inline constexpr double grain_density = 2650, radius = 0.1e-3, roughness = 20e-9, alpha = 1.5;

struct Packing {
  std::string contact; ///< sphere, rough or power-law
  std::string recipe;
  int seed = 0;
  State state; ///< with its own law and counted C_n
  double mechanical_coordination = 0, rattler_fraction = 0;
  double shear_modulus = 0, bulk_modulus = 0; ///< of the network [Pa]

  [[nodiscard]] std::string specimen() const { return contact + " " + recipe + " " + std::to_string(seed); }
  /// The recipe as the contact prior knows it.
  [[nodiscard]] granum::effective::Preparation preparation() const {
    using granum::effective::Preparation;
    if (recipe == "dense")
      return {.kind = Preparation::Kind::dense};
    return {.kind = Preparation::Kind::friction, .friction_coefficient = recipe == "slippery" ? 0.1 : 0.4986};
  }
};

inline granum::contact::NormalLaw law_of(const std::string& contact) {
  using granum::contact::PowerLaw;
  if (contact == "sphere")
    return PowerLaw::sphere(quartz, radius);
  if (contact == "rough")
    return granum::contact::RoughSphere(quartz, radius, roughness);
  return PowerLaw::general(quartz, alpha, 180);
}

/// In the order of the file: the pressures of a specimen rise.
inline std::vector<Packing> read(const std::string& path) {
  std::vector<Packing> all;
  for (const Entry& row : read_record(path))
    all.push_back(
        {.contact = row.text("contact"),
         .recipe = row.text("recipe"),
         .seed = static_cast<int>(row("seed")),
         .state = {.law = law_of(row.text("contact")),
                   .tangential_ratio = granum::contact::mindlin_stiffness_ratio(quartz.poisson_ratio),
                   .radius = radius,
                   .void_ratio = row("e"),
                   .coordination_number = row("C_n"),
                   .stress_v = row("p_Pa"),
                   .stress_h = row("p_Pa")},
         .mechanical_coordination = row("z_star"),
         .rattler_fraction = row("rattler_fraction"),
         .shear_modulus = row("G_network_Pa"),
         .bulk_modulus = row("K_network_Pa")});
  return all;
}

} // namespace infer_packings
