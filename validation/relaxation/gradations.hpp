// SPDX-License-Identifier: GPL-3.0-or-later
// Spheres of six gradations, as packings of the fits: how far G and K scatter where grains differ is fitted
// to them too.
#pragma once

#include <string>
#include <vector>

#include <granum/contact/power_law.hpp>
#include <granum/core/text.hpp>
#include <granum/effective/uniform_field.hpp>

#include "reading.hpp"

namespace relaxation {

/// Of a record of gradation_run, whose networks have one k_t/k_n and isotropic moduli. Grains of another mean
/// size are left out: those packings are the same but for their scale.
inline std::vector<Packing> read_gradations(const std::string& path) {
  constexpr double usual_radius = 0.5e-3, pressure = 100e3;
  const granum::io::CsvTable table = granum::io::read_csv(path);
  std::vector<Packing> packings;
  for (std::size_t k = 0; k < table.row_count(); ++k) {
    const std::vector<std::string>& fields = table.fields(k);
    const std::string &sizes = fields[0], &preparation = fields[1];
    const detail::Row row = detail::numbers(table.headings(), fields);
    if (row.at("mean_radius_m") != usual_radius)
      continue;
    const State state = detail::state(row, "sphere", granum::contact::mindlin_stiffness_ratio(0.15));
    const double K = row.at("K_network_Pa"), G = row.at("G_network_Pa");
    const std::string recipe = "sphere " + preparation + " " + sizes;
    Packing p{.sizes = sizes,
              .contact = "sphere",
              .preparation = preparation,
              .recipe = recipe,
              .specimen = recipe + " " + granum::short_text(row.at("seed")),
              .seed = static_cast<int>(row.at("seed")),
              .pressure = pressure,
              .friction_coefficient = row.at("friction_coefficient"),
              .state = state,
              .mechanical_coordination = row.at("z_star"),
              .rattler_fraction = row.at("rattler_fraction"),
              .uniformity = row.at("C_u"),
              .affine_share = 1,
              .networks = {}};
    p.relative_overlap = detail::relative_overlap(state);
    p.strain_bulk_modulus = detail::closed_strain_bulk_modulus(p);
    p.unevenness = detail::unevenness(p, row.at("G_affine_Pa"), row.at("G_uniform_strain_Pa"));
    p.networks.push_back(
        {state.tangential_ratio,
         {.C11 = K + 4 * G / 3, .C33 = K + 4 * G / 3, .C12 = K - 2 * G / 3, .C13 = K - 2 * G / 3, .C44 = G}});
    packings.push_back(p);
  }
  return packings;
}

} // namespace relaxation
