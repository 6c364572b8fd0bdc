// SPDX-License-Identifier: GPL-3.0-or-later
// Reads states.csv of a `granum verify`: packings that no fit has seen.
#pragma once

#include <string>
#include <vector>

#include "reading.hpp"

namespace relaxation {

/// States of `granum verify`, whose moduli are those of the isotropic network. Dense ones were made without
/// friction, loose ones with that of Table 1 of the paper.
inline std::vector<Packing> read_verify_states(const std::string& path) {
  constexpr double ratio = 0.918918918918919, friction_of_the_paper = 0.4986;
  const granum::io::CsvTable table = granum::io::read_csv(path);
  std::vector<Packing> packings;
  for (std::size_t k = 0; k < table.row_count(); ++k) {
    const std::vector<std::string>& fields = table.fields(k);
    detail::Row row = detail::numbers(table.headings(), fields);
    row["stress_v_Pa"] = row["stress_h_Pa"] = row.at("p_contacts_Pa");
    const double G = row.at("G_network_Pa"), K = row.at("K_network_Pa");
    const std::string recipe = fields[0] + " " + fields[1];
    packings.push_back({.contact = fields[0],
                        .preparation = fields[1],
                        .recipe = recipe,
                        .specimen = recipe + " " + fields[2],
                        .seed = static_cast<int>(row.at("seed")),
                        .pressure = row.at("p_Pa"),
                        .friction_coefficient = fields[1] == "dense" ? 0 : friction_of_the_paper,
                        .state = detail::state(row, fields[0], ratio),
                        .mechanical_coordination = row.at("z_star"),
                        .rattler_fraction = row.at("rattler_fraction"),
                        .networks = {{ratio,
                                      {.C11 = K + 4 * G / 3,
                                       .C33 = K + 4 * G / 3,
                                       .C12 = K - 2 * G / 3,
                                       .C13 = K - 2 * G / 3,
                                       .C44 = G}}}});
    Packing& p = packings.back();
    p.state.fabric_anisotropy = 0;
    p.relative_overlap = detail::relative_overlap(p.state);
    p.unevenness = detail::unevenness(p, row.at("G_uniform_strain_Pa"), row.at("G_closed_Pa"));
  }
  return packings;
}

} // namespace relaxation
