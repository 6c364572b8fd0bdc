// SPDX-License-Identifier: GPL-3.0-or-later
// Networks large enough for pieces and a coarse grid.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "packing/sample_packings.hpp"

namespace granum::samples {

/// Grains on a simple cubic lattice, joined along its edges and the diagonals of its faces, of which a share
/// is kept, all stiffnesses unequal; periodic.
inline packing::Assembly large_network(int side, double kept, double tangential_ratio = 1,
                                       std::uint64_t seed = 31) {
  Uniform uniform(seed);
  packing::Assembly a;
  a.cell = Mat3::diagonal(side, side, side);
  const auto number = [side](int x, int y, int z) {
    const auto wrapped = [side](int k) { return (k % side + side) % side; };
    return static_cast<std::uint32_t>((wrapped(x) * side + wrapped(y)) * side + wrapped(z));
  };
  const int steps[9][3] = {{1, 0, 0}, {0, 1, 0},  {0, 0, 1}, {1, 1, 0}, {1, -1, 0},
                           {0, 1, 1}, {0, 1, -1}, {1, 0, 1}, {1, 0, -1}};
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      for (int z = 0; z < side; ++z) {
        a.position.push_back(Vec3{x + 0.5, y + 0.5, z + 0.5} + uniform.vector(0.02));
        a.radius.push_back(uniform(0.4, 0.6));
      }
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      for (int z = 0; z < side; ++z)
        for (const auto& s : steps) {
          const double stiffness = uniform(0.5, 2), ratio = tangential_ratio * uniform(0.2, 1);
          if (uniform(0, 1) >= kept)
            continue;
          packing::Contact c{
              .i = number(x, y, z), .j = number(x + s[0], y + s[1], z + s[2]), .tangential_force = {}};
          Vec3 apart = a.position[c.j] - a.position[c.i];
          for (int k = 0; k < 3; ++k)
            apart[k] -= side * std::round(apart[k] / side);
          c.branch = apart;
          if (c.i > c.j) {
            std::swap(c.i, c.j);
            c.branch = -c.branch;
          }
          c.normal_stiffness = stiffness;
          c.tangential_stiffness = ratio * stiffness;
          a.contacts.push_back(c);
        }
  std::sort(a.contacts.begin(), a.contacts.end(), [](const packing::Contact& c, const packing::Contact& d) {
    return c.i != d.i ? c.i < d.i : c.j < d.j;
  });
  return a;
}

} // namespace granum::samples
