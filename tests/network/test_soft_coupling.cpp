// SPDX-License-Identifier: GPL-3.0-or-later
// A row of grains that move along x: 2 - 1 - 0 on stiff springs, 0 on a weak one to a wall and on another to
// 3, and 2 on a weak one to 3. Pushed, 2 takes 1 and 0 along, and 3 feels both weak springs. A factor without
// fill has no place for 1 and 3, so that its elimination knows only of the spring between 2 and 3.
#include <Eigen/LU>

#include "network/factor/elimination.hpp"
#include "unit.hpp"

using namespace granum::network;

namespace {

constexpr double to_wall = 1e-3, from_0_to_3 = 4e-3, from_2_to_3 = 1e-3;

Link spring(std::uint32_t a, std::uint32_t b, const Vec3& normal, double stiffness = 1) {
  return {.a = a, .b = b, .normal = normal, .length = 1, .lever = 0.5, .normal_stiffness = stiffness};
}

Backbone row_of_grains() {
  constexpr Vec3 x{1, 0, 0};
  Backbone backbone;
  backbone.grain_count = 4;
  backbone.stages = {{{0, 4}}};
  backbone.links = {spring(0, 1, x), spring(1, 2, x), spring(0, 3, x, from_0_to_3),
                    spring(2, 3, x, from_2_to_3)};
  for (std::uint32_t g = 0; g < 4; ++g) {
    backbone.wall_links.push_back(spring(g, g, {0, 1, 0}));
    backbone.wall_links.push_back(spring(g, g, {0, 0, 1}));
    if (g == 0 || g == 3)
      backbone.wall_links.push_back(spring(g, g, x, g == 0 ? to_wall : 1));
  }
  return backbone;
}

TEST_CASE(
    "a soft pivot is coupled with later grains as its motion says, not as an incomplete elimination does") {
  const Backbone backbone = row_of_grains();
  const FillPattern pattern = fill_pattern(backbone, 0);
  REQUIRE(pattern.size() == backbone.links.size());
  const Eliminated<3> made =
      eliminate<3>(backbone, Workers(nullptr), {.shift = 1e-12, .soft_pivots = SoftPivots::coupled}, pattern);

  // Where 2 moves by 1: 1 and 0 are in balance, 3 stands still.
  const double x0 = 1 / (2 * (1 + to_wall + from_0_to_3) - 1), x1 = (1 + x0) / 2;
  const double energy = (1 - x1) + from_2_to_3, force_on_3 = -(from_2_to_3 + from_0_to_3 * x0);

  using Square = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  using Map = Eigen::Map<const Square>;
  const Map root_2(&made.root[2].at[0][0]);
  CHECK(std::abs(root_2(0, 0)) == doctest::Approx(1 / std::sqrt(energy)).epsilon(1e-10));
  // L of the last row and column 2, transposed; over the root of 3 it is the force in the motion of energy 1
  REQUIRE(pattern.column[pattern.row_start[3] + 1] == 2);
  const std::vector<Block<3>>& lower = made.lower[0];
  const Map stored(&lower[pattern.row_start[3] + 1].at[0][0]);
  const Square force = stored * Map(&made.root[3].at[0][0]).inverse();
  CHECK(force(0, 0) * root_2(0, 0) == doctest::Approx(force_on_3 / energy).epsilon(1e-10));
  CHECK(force.row(0).tail<2>().norm() < 1e-12);
}

} // namespace
