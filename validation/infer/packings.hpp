// SPDX-License-Identifier: GPL-3.0-or-later
// Reads states.csv: packings whose contacts and moduli are known, which no fit has seen.
#pragma once

#include <string>
#include <vector>

#include <granum/contact/power_law.hpp>
#include <granum/contact/rough_sphere.hpp>
#include <granum/effective/contact_prior.hpp>
#include <granum/effective/state.hpp>
#include <granum/io/csv/table.hpp>

namespace infer_packings {

using granum::Dimension;
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
  const granum::io::CsvTable table = granum::io::read_csv(path);
  const auto number = [&](const char* name) { return table.numbers(name, Dimension::dimensionless); };
  const auto stress = [&](const char* name) { return table.numbers(name, Dimension::pressure); };
  const auto e = number("e"), C_n = number("C_n"), z = number("z_star"), x = number("rattler_fraction"),
             seed = number("seed");
  const auto p = stress("p"), G = stress("G_network"), K = stress("K_network");
  std::vector<Packing> all;
  for (std::size_t k = 0; k < table.row_count(); ++k) {
    const std::string contact = table.fields(k)[0];
    all.push_back(
        {.contact = contact,
         .recipe = table.fields(k)[1],
         .seed = static_cast<int>(seed[k]),
         .state = {.law = law_of(contact),
                   .tangential_ratio = granum::contact::mindlin_stiffness_ratio(quartz.poisson_ratio),
                   .radius = radius,
                   .void_ratio = e[k],
                   .coordination_number = C_n[k],
                   .stress_v = p[k],
                   .stress_h = p[k]},
         .mechanical_coordination = z[k],
         .rattler_fraction = x[k],
         .shear_modulus = G[k],
         .bulk_modulus = K[k]});
  }
  return all;
}

} // namespace infer_packings
