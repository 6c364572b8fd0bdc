// SPDX-License-Identifier: GPL-3.0-or-later
// Three spheres at a right angle in a periodic cube of 4 mm: R = 0.5 mm, E = 69 GPa, nu = 0.15, overlaps 1e-7
// m and 2e-7 m. The forces are those printed alike by LAMMPS, LIGGGHTS and YADE for this state (Hertz).
#pragma once

#include <granum/packing/assembly.hpp>

namespace granum::samples {

inline constexpr double chain_force_ab = 0.0235294118; // [N]
inline constexpr double chain_force_bc = 0.0665512265; // [N]

inline packing::Assembly sphere_chain() {
  packing::Assembly a;
  a.cell = {{{4e-3, 0, 0}, {0, 4e-3, 0}, {0, 0, 4e-3}}};
  a.position = {{1e-3, 2e-3, 2e-3}, {1.9999e-3, 2e-3, 2e-3}, {1.9999e-3, 2e-3, 2.9998e-3}};
  a.radius = {0.5e-3, 0.5e-3, 0.5e-3};
  const auto contact = [](std::uint32_t i, const Vec3& branch, double overlap, double force) {
    const double stiffness = 1.5 * force / overlap; // Hertz: f ~ d^(3/2)
    return packing::Contact{.i = i,
                            .j = i + 1,
                            .branch = branch,
                            .overlap = overlap,
                            .normal_force = force,
                            .tangential_force = {},
                            .normal_stiffness = stiffness,
                            .tangential_stiffness = 2 * (1 - 0.15) / (2 - 0.15) * stiffness};
  };
  a.contacts = {contact(0, {0.9999e-3, 0, 0}, 1e-7, chain_force_ab),
                contact(1, {0, 0, 0.9998e-3}, 2e-7, chain_force_bc)};
  return a;
}

} // namespace granum::samples
