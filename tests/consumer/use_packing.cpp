// SPDX-License-Identifier: GPL-3.0-or-later
// Needs granum::packing alone: counts the contacts of a packing and computes its stiffness.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <tuple>

#include <granum/network/linear_response.hpp>
#include <granum/packing/coordination.hpp>

int main() {
  // Three grains a side of a simple cubic lattice; diameter 1, k_n = 1: C_11 = k_n/(2R) = 1.
  constexpr std::array<std::uint32_t, 3> step{1, 3, 9};
  granum::packing::Assembly lattice;
  lattice.cell = 3.0 * granum::Mat3::identity();
  for (std::uint32_t g = 0; g < 27; ++g) {
    lattice.position.push_back({double(g % 3), double(g / 3 % 3), double(g / 9)});
    lattice.radius.push_back(0.5);
    for (int axis = 0; axis < 3; ++axis) {
      const std::uint32_t along = step[axis],
                          last = g / along % 3 == 2; // whose neighbour is through the face
      granum::packing::Contact contact{.i = last ? g - 2 * along : g, .j = last ? g : g + along};
      contact.branch[axis] = last ? -1 : 1;
      contact.normal_stiffness = 1;
      contact.tangential_stiffness = 0.5;
      lattice.contacts.push_back(contact);
    }
  }
  std::sort(lattice.contacts.begin(), lattice.contacts.end(),
            [](const auto& a, const auto& b) { return std::tie(a.i, a.j) < std::tie(b.i, b.j); });
  const double coordination = granum::packing::coordination_number(lattice);
  const double stiffness = granum::network::linear_response(lattice).relaxed().matrix(0, 0);
  std::printf("C_n = %g, C_11 = %.15g k_n/(2R)\n", coordination, stiffness);
  return coordination == 6 && std::abs(stiffness - 1) < 1e-13 ? 0 : 1; // rounding of some dozens of terms
}
