// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/io/imported_packing.hpp>

namespace granum::samples {

/// A packing with something different in each place.
inline io::ImportedPacking hdf5_sample() {
  io::ImportedPacking packing;
  Assembly& a = packing.assembly;
  a.cell = Mat3::diagonal(4e-3, 5e-3, 6e-3);
  a.cell(0, 2) = 1e-3 / 3;
  a.position = {{1e-3, 2e-3, 2e-3}, {1.9e-3, 2e-3, 2e-3}, {1e-3, 2e-3, 2.7e-3}};
  a.radius = {0.5e-3, 0.5e-3, 0.25e-3};
  a.contacts = {{.i = 0, .j = 1, .branch = {0.9e-3, 0, 0}, .overlap = 1e-4, .normal_force = 2},
                {.i = 0,
                 .j = 2,
                 .branch = {0, 0, 0.7e-3},
                 .overlap = 5e-5,
                 .normal_force = 1.0 / 3,
                 .tangential_force = {0.1, -0.2, 0},
                 .normal_stiffness = 2e5,
                 .tangential_stiffness = 1e5 / 7,
                 .sliding = true}};
  a.wall_contacts = {{.i = 2, .j = 5, .branch = {0, 0, 0.2e-3}, .overlap = 5e-5, .normal_force = 3}};
  packing.id = {-4, 7, 1'000'000'000'000};
  packing.periodic = {true, true, false};
  packing.step = 20;
  packing.time = 0.1;
  return packing;
}

} // namespace granum::samples
