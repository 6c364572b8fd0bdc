// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/sweep/grain_motion.hpp"

#include "unit.hpp"

using namespace granum::dem;

namespace {

constexpr std::size_t grain_total = 7;

template <class AnyGrains>
AnyGrains moving_grains() {
  AnyGrains grains;
  grains.resize(grain_total);
  for (std::size_t g = 0; g < grain_total; ++g) {
    const double n = static_cast<double>(g);
    grains.set_centre(g, {n, 2 - n, 0.5 * n});
    grains.set_velocity(g, {0.1 * n + 0.4, 0.3, -0.2 * n});
  }
  return grains;
}

template <class Row>
std::vector<Row> forces() {
  std::vector<Row> load(grain_total, Row{});
  for (std::size_t g = 0; g < grain_total; ++g)
    add_force(load[g], {1, -static_cast<double>(g), 0.25});
  return load;
}

/// One of each grain's own, from 1 to 4.
double mass_of(std::size_t g) { return 1 + 0.5 * static_cast<double>(g); }

TranslatingGrains with_masses(TranslatingGrains grains) {
  std::vector<OwnSize> own;
  for (std::size_t g = 0; g < grain_total; ++g)
    own.push_back({.size = 1, .radius = 1, .mass = mass_of(g), .per_mass = 1 / mass_of(g)});
  grains.set_sizes(own);
  return grains;
}

} // namespace

TEST_CASE("sums over forces include spare rows, for any number of grains") {
  const auto grains = moving_grains<TranslatingGrains>();
  const Vec3 lent{0.5, 4, -3};
  const std::vector<Addition> additions = {{grain_total, 2}};
  for (std::size_t end = 3; end <= grain_total; ++end) {
    CAPTURE(end);
    std::vector<PushRow> load = forces<PushRow>();
    load.push_back(PushRow{});
    add_force(load.back(), lent);
    const Chunk chunk{.grains = {1, end}, .pairs = {}, .spare_rows = {}, .additions = {0, 1}};
    PushSums expected;
    double lengths = 0;
    for (std::size_t g = 1; g < end; ++g) {
      const Vec3 f = force(load[g]) + (g == 2 ? lent : Vec3{});
      expected += {.power = dot(f, grains.velocity(g)),
                   .squares = dot(f, f),
                   .components = std::abs(f.x) + std::abs(f.y) + std::abs(f.z)};
      lengths += norm(f);
    }
    const PushSums sums = settle_pushes(grains, chunk, additions, load);
    CHECK(sums.power == relative(expected.power, 1e-14));
    CHECK(sums.squares == relative(expected.squares, 1e-14));
    CHECK(sums.components == relative(expected.components, 1e-14));
    CHECK(lengths_of_forces(chunk, load) == lengths);
    CHECK(force(load.back()) == Vec3{});
  }
}

TEST_CASE("a kick finds the fastest grain wherever it is") {
  const Kick kick{.keep = 0.9, .push = 0.3, .turn = 0.2};
  for (std::size_t end = 1; end <= grain_total; ++end)
    for (std::size_t fast = 0; fast < end; ++fast) {
      CAPTURE(end);
      CAPTURE(fast);
      auto grains = moving_grains<Grains>();
      const std::vector<LoadRow> load = forces<LoadRow>();
      grains.set_velocity(fast, {-5, 4, 3});
      const Vec3 v = kick.keep * Vec3{-5, 4, 3} + kick.push * force(load[fast]);
      const MotionSums sums = kick_grains(grains, {0, end}, load, kick, 1.5, 1);
      CHECK(norm(grains.velocity(fast) - v) < 1e-14);
      CHECK(sums.speed_squared == relative(dot(v, v), 1e-14));
      double kinetic = 0, power = 0;
      for (std::size_t g = 0; g < end; ++g) {
        kinetic += 1.5 * dot(grains.velocity(g), grains.velocity(g));
        power += dot(force(load[g]), grains.velocity(g));
      }
      CHECK(sums.kinetic == relative(kinetic, 1e-14));
      CHECK(sums.power == relative(power, 1e-14));
    }
}

TEST_CASE("grains glide with their new velocities, less if heavier, at most at a largest one, and the cell") {
  for (const bool unequal : {false, true}) {
    CAPTURE(unequal);
    const auto mass = [&](std::size_t g) { return unequal ? mass_of(g) : 1.0; };
    const auto equal = moving_grains<TranslatingGrains>();
    const TranslatingGrains before = unequal ? with_masses(equal) : equal;
    std::vector<PushRow> load = forces<PushRow>();
    const Chunk all{.grains = {0, grain_total}, .pairs = {}, .spare_rows = {}, .additions = {0, 0}};
    const PushSums pushes = settle_pushes(before, all, {}, load);
    std::vector<PushRow> taken = load;
    const Glide glide{.keep = 0.9, .push = 0.3, .dt = 0.01, .growth = 1.5, .largest = 1};
    TranslatingGrains grains = before;
    const GlideSums sums = glide_grains(grains, taken, glide);
    double power = 0, pull = 0, squares = 0, fastest = 0;
    for (std::size_t g = 0; g < grain_total; ++g) {
      CHECK(force(taken[g]) == Vec3{});
      const Vec3 f = force(load[g]);
      Vec3 v = glide.keep * before.velocity(g) + glide.push / mass(g) * f;
      fastest = std::max(fastest, norm(v));
      if (norm(v) > glide.largest)
        v *= glide.largest / norm(v);
      power += dot(f, before.velocity(g));
      pull += dot(f, f) / mass(g);
      squares += mass(g) * dot(v, v);
      CHECK(norm(grains.velocity(g) - v) < 1e-15);
      CHECK(norm(grains.centre(g) - glide.growth * (before.centre(g) + glide.dt * v)) < 1e-14);
    }
    CHECK(norm(grains.velocity(0)) < 1); // some were too fast, and some were not
    CHECK(fastest > 1);
    CHECK(sums.fastest == relative(fastest, 1e-14));
    CHECK(pushes.power == relative(power, 1e-14));
    CHECK(pushes.squares == relative(pull, 1e-14));
    CHECK(sums.squares == relative(squares, 1e-14));
  }
}
