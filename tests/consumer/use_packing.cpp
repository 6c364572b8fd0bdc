// SPDX-License-Identifier: GPL-3.0-or-later
// Needs granum::packing alone: counts the contacts of a packing and computes its stiffness.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <tuple>
#include <utility>

#include <granum/network/linear_response.hpp>
#include <granum/packing/coordination.hpp>

int main() {
  // Three grains a side of a simple cubic lattice; diameter 1, k_n = 1: C_11 = k_n/(2R) = 1.
  constexpr int side = 3;
  const auto index = [](int x, int y, int z) {
    return static_cast<std::uint32_t>((z % side * side + y % side) * side + x % side);
  };
  granum::packing::Assembly lattice;
  lattice.cell = double{side} * granum::Mat3::identity();
  for (int z = 0; z < side; ++z)
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        lattice.position.push_back({double(x), double(y), double(z)});
        lattice.radius.push_back(0.5);
        for (int axis = 0; axis < 3; ++axis) {
          granum::packing::Contact contact;
          contact.i = index(x, y, z);
          contact.j = index(x + (axis == 0), y + (axis == 1), z + (axis == 2));
          contact.branch[axis] = 1;
          if (contact.i > contact.j) {
            std::swap(contact.i, contact.j);
            contact.branch[axis] = -1;
          }
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
