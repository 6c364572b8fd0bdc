// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tuple>

#include <granum/analysis/measure.hpp>

#include "unit.hpp"

/// Packings that can be measured by hand.
namespace lattices {

using namespace granum::analysis;

inline constexpr double R = 0.5e-3, edge = 2 * R - 1e-6, k_n = 2e5, k_t = 1e5, f_n = 0.1;
inline const contact::PowerLaw law = contact::PowerLaw::sphere({30e9, 0.15}, R);

/// Three spheres in a row: a touches b, and b touches c.
inline packing::Assembly row() {
  return {.cell = Mat3::diagonal(4e-3, 4e-3, 4e-3),
          .position = {{1e-3, 1e-3, 1e-3}, {1e-3 + edge, 1e-3, 1e-3}, {1e-3 + 2 * edge, 1e-3, 1e-3}},
          .radius = {R, R, R},
          .contacts = {{.i = 0, .j = 1, .branch = {edge, 0, 0}, .overlap = 1e-6, .normal_force = f_n},
                       {.i = 1, .j = 2, .branch = {edge, 0, 0}, .overlap = 1e-6, .normal_force = 3 * f_n}}};
}

/// 27 spheres on a periodic simple cubic lattice, pressed by the same force along all axes.
inline packing::Assembly cubic() {
  packing::Assembly out{
      .cell = Mat3::diagonal(3 * edge, 3 * edge, 3 * edge), .position = {}, .radius = {}, .contacts = {}};
  const auto at = [](int x, int y, int z) {
    return static_cast<std::uint32_t>((x % 3) * 9 + (y % 3) * 3 + z % 3);
  };
  for (int x = 0; x < 3; ++x)
    for (int y = 0; y < 3; ++y)
      for (int z = 0; z < 3; ++z) {
        out.position.push_back({x * edge, y * edge, z * edge});
        out.radius.push_back(R);
        for (int axis = 0; axis < 3; ++axis) {
          const std::uint32_t here = at(x, y, z),
                              next = at(x + (axis == 0), y + (axis == 1), z + (axis == 2));
          packing::Contact c{.i = std::min(here, next), .j = std::max(here, next), .overlap = 2 * R - edge};
          c.branch[axis] = here < next ? edge : -edge;
          c.normal_force = f_n;
          c.normal_stiffness = k_n;
          c.tangential_stiffness = k_t;
          out.contacts.push_back(c);
        }
      }
  std::sort(out.contacts.begin(), out.contacts.end(),
            [](const packing::Contact& a, const packing::Contact& b) {
              return std::tie(a.i, a.j) < std::tie(b.i, b.j);
            });
  return out;
}

inline const Given own{.law = law, .tangential_ratio = 0.5};

} // namespace lattices
