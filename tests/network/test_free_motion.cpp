// SPDX-License-Identifier: GPL-3.0-or-later
// A chain of levers: what the last grain moves, the first moves 28,700 times as far. Nothing resists it but a
// spring at the last grain, which is lost beside the terms that cancel at the first.
#include "network/contact_operator.hpp"
#include "network/factor/incomplete_factor.hpp"

#include "unit.hpp"

using namespace granum::network;

namespace {

constexpr double weakest = 1e-8;
constexpr double arms[] = {29.7, 31.3, 30.9};

Link spring(std::uint32_t a, std::uint32_t b, const Vec3& normal) {
  return {.a = a, .b = b, .normal = normal, .length = 1, .lever = 0.5, .normal_stiffness = 1};
}

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
  backbone.wall_links.push_back(spring(3, 3, {0, 1, 0}));
  backbone.wall_links.back().normal_stiffness = weakest;
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
