// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/LU>

#include "network/contact_operator.hpp"
#include "network/factor/elimination.hpp"
#include "network/factor/incomplete_factor.hpp"

#include "unit.hpp"

using namespace granum::network;

namespace {

Link spring(std::uint32_t a, std::uint32_t b, const Vec3& normal, double stiffness = 1) {
  return {.a = a, .b = b, .normal = normal, .length = 1, .lever = 0.5, .normal_stiffness = stiffness};
}

// A chain of levers: what the last grain moves, the first moves 28,700 times as far. Nothing resists it but a
// spring at the last grain, which is lost beside the terms that cancel at the first.
constexpr double weakest = 1e-8;
constexpr double arms[] = {29.7, 31.3, 30.9};

/// Four grains that springs to a wall hold but along x and y in turn. The spring between two of them lets the
/// earlier one move so many times as far as the later one.
Backbone levers() {
  Backbone backbone;
  backbone.grain_count = 4;
  backbone.stages = {{{0, 4}}};
  for (std::uint32_t g = 0; g < 4; ++g) {
    backbone.wall_links.push_back(spring(g, g, g % 2 == 0 ? Vec3{0, 1, 0} : Vec3{1, 0, 0}));
    backbone.wall_links.push_back(spring(g, g, {0, 0, 1}));
  }
  for (std::uint32_t g = 0; g < 3; ++g) {
    const double length = std::sqrt(1 + 1 / (arms[g] * arms[g]));
    const double along = 1 / (arms[g] * length), across = 1 / length; // of the earlier and the later grain
    backbone.links.push_back(spring(g, g + 1, g % 2 == 0 ? Vec3{along, across, 0} : Vec3{across, along, 0}));
  }
  backbone.wall_links.push_back(spring(3, 3, {0, 1, 0}, weakest));
  return backbone;
}

/// Displacements in the free motion.
Field<3> free_motion() {
  Field<3> motion(4);
  double step = 1;
  for (std::size_t g = 4; g-- > 0;) {
    motion[g].row[g % 2] += step;
    step *= g > 0 ? arms[g - 1] : 1;
  }
  return motion;
}

double largest(const Field<3>& x) {
  double most = 0;
  for (const Rows<3>& grain : x)
    for (const Lanes& row : grain.row)
      most = std::max(most, std::abs(row[0]));
  return most;
}

} // namespace

TEST_CASE("a motion resisted only by rounding counts as rigid in the check of pivots") {
  const Backbone backbone = levers();
  const Workers alone;
  const Field<3> motion = free_motion();
  CHECK(largest(motion) > 28000);
  Field<3> answer;
  apply_stiffness<3>(backbone, alone, 0, motion, answer);
  CHECK(largest(answer) < 2 * weakest);

  const FactorRule judged{.fill_level = 3, .shift = 1e-12, .soft_pivots = SoftPivots::by_motion};
  const IncompleteFactor<3> factor(backbone, alone, judged);
  Field<3> load(4), moved(4);
  load[3].row[1] += 1; // the last grain, along the way that it is free to go
  factor.solve(load, moved);
  CHECK(largest(moved) < 10);
  load[3].row[1] -= 1;
  load[2].row[1] += 1; // against a spring to the wall
  factor.solve(load, moved);
  const double of_third = moved[2].row[1][0];
  CHECK(of_third > 0.3);
}

namespace {

// A row of grains that move along x: 2 - 1 - 0 on stiff springs, 0 on a weak one to a wall and on another to
// 3, and 2 on a weak one to 3. Pushed, 2 takes 1 and 0 along, and 3 feels both weak springs. A factor without
// fill has no place for 1 and 3, so that its elimination knows only of the spring between 2 and 3.
constexpr double to_wall = 1e-3, from_0_to_3 = 4e-3, from_2_to_3 = 1e-3;

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

} // namespace

TEST_CASE(
    "a soft pivot is coupled with later grains as its motion says, not as an incomplete elimination does") {
  const Backbone backbone = row_of_grains();
  const FillPattern pattern = fill_pattern(backbone, 0);
  REQUIRE(pattern.size() == backbone.links.size());
  const Eliminated<3> made =
      eliminate<3>(backbone, Workers(nullptr), {.shift = 1e-12, .soft_pivots = SoftPivots::coupled}, pattern);

  // Where 2 moves by 1: 1 and 0 are in balance, 3 is at rest.
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
