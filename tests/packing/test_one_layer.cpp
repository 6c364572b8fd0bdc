// SPDX-License-Identifier: GPL-3.0-or-later
// Packings in two dimensions are refused, layers of lattices in space are not.
#include <granum/packing/one_layer.hpp>

#include "thresholds.hpp"
#include "unit.hpp"

using packing::Assembly;

namespace {

/// A square lattice of discs at z = 0.3, in a cell of some thickness.
Assembly discs(int edge, double thickness) {
  Assembly out{.cell = Mat3::diagonal(edge, edge, thickness), .position = {}, .radius = {}, .contacts = {}};
  for (int i = 0; i < edge; ++i)
    for (int j = 0; j < edge; ++j)
      out.position.push_back({1.0 * i, 1.0 * j, 0.3});
  out.radius.assign(out.position.size(), 0.5);
  return out;
}

} // namespace

TEST_CASE("one layer: discs in a plane are refused along any axis") {
  for (const double thickness : {0.1, 0.7, 1.0, 30.0}) {
    CHECK_THROWS_WITH_AS(require_space(discs(4, thickness)), doctest::Contains("z = 300 mm"),
                         InvalidArgument);
    CHECK_NOTHROW(require_space(discs(3, thickness))); // a chain or a few grains are nobody's disc
  }
  Assembly row = discs(4, 9);
  for (std::size_t g = 0; g < row.grain_count(); ++g)
    row.position[g] = {0.2, 1.0 * static_cast<double>(g), 0.3};
  CHECK_NOTHROW(require_space(row)); // on a line
  Assembly turned = discs(4, 9);
  for (Vec3& x : turned.position)
    x = {x.z, x.x, x.y};
  CHECK_THROWS_WITH_AS(require_space(turned), doctest::Contains("x = 300 mm"), InvalidArgument);
}

TEST_CASE("one layer: a grain or a contact beside the plane makes it a packing in space") {
  Assembly packing = discs(4, 9);
  packing.contacts = {{.i = 0, .j = 1, .branch = {0, 1, 0}}};
  CHECK_THROWS_AS(require_space(packing), InvalidArgument);
  packing.contacts.push_back({.i = 0, .j = 1, .branch = {0, 0, 1}}); // with an image
  CHECK_NOTHROW(require_space(packing));
  packing.contacts.clear();
  packing.wall_contacts = {{.i = 3, .j = 0, .branch = {0, 0, -0.5}}}; // between plates
  CHECK_NOTHROW(require_space(packing));
  const auto in_space = [](const Assembly& assembly) {
    return 1 - refusals([&] { require_space(assembly); });
  };
  check_threshold(1e-6 * 0.5, [&](double off) { // rounding of the largest radius
    Assembly all = discs(4, 9);
    all.position[7].z += off;
    return in_space(all);
  });
  for (const double thickness : {0.8, 1.0}) // a simple cubic lattice within: images touch
    check_threshold(thickness, [&](double width) { return in_space(discs(4, width)); });
  Assembly few = discs(4, 9);
  for (const auto& [grains, free] : {std::pair(10, 0), {9, 1}}) {
    few.position.resize(static_cast<std::size_t>(grains));
    few.radius.resize(static_cast<std::size_t>(grains));
    CHECK(in_space(few) == free);
  }
}
