// SPDX-License-Identifier: GPL-3.0-or-later
#include <numeric>

#include <granum/dem/engine.hpp>

#include "core/team.hpp"
#include "dem/sweep/partition.hpp"
#include "lattice_state.hpp"
#include "unit.hpp"

using namespace granum::dem;

namespace {

using test::radius;

/// A lattice of 4 * 11^3 grains in motion, equal or of sizes from 1/2 to 1: contacts open, close and slide.
Engine lively(double friction, bool walls, bool unequal = false) {
  Specimen state = test::fcc(radius, 11, 2e-7 + (unequal ? 0.5 * radius : 0));
  for (std::size_t g = 0; g < state.grain_count(); ++g) {
    const double phase = static_cast<double>(g);
    if (unequal)
      state.size.push_back(0.75 + 0.25 * std::sin(13 * phase));
    state.velocity[g] = 1e-2 * Vec3{std::sin(5 * phase), std::sin(3 * phase + 1), std::cos(2 * phase)};
    state.angular_velocity[g] = 2 * Vec3{std::cos(phase), std::sin(7 * phase), std::cos(4 * phase)};
  }
  if (walls)
    state.walls = Walls{.friction_coefficient = 0.3, .history = {}};
  return {std::move(state), test::quartz(radius, friction)};
}

void run(Engine& engine, int steps) {
  for (int k = 0; k < steps; ++k) {
    engine.set_velocity_gradient(4e-6 / engine.time_step() * Mat3::diagonal(1, -1.5, 0.2));
    engine.step();
  }
}

void check_same(const Engine& one, const Engine& other) {
  CHECK(one.state() == other.state());
  CHECK(one.figures().stress == other.figures().stress);
  CHECK(one.figures().mean_normal_force == other.figures().mean_normal_force);
  CHECK(one.figures().p_wave_modulus == other.figures().p_wave_modulus);
  CHECK(one.wall_forces().force == other.wall_forces().force);
  CHECK(one.kinetic_energy() == other.kinetic_energy());
  CHECK(one.unbalanced_force_ratio() == other.unbalanced_force_ratio());
  CHECK(one.time_step() == other.time_step());
}

Engine reloaded(const Engine& engine) {
  ByteWriter bytes;
  engine.save(bytes);
  ByteReader reader(bytes.bytes(), "bytes");
  return Engine::load(reader, engine.material());
}

} // namespace

TEST_CASE("any number of threads gives the same bits, before and after save and load") {
  for (const int kind : {0, 1, 2, 3, 4, 5, 6, 7}) {
    const bool walls = kind % 2 == 1, unequal = kind >= 4;
    for (const double friction : {0.2, 0.0}) {
      CAPTURE(walls);
      CAPTURE(friction);
      CAPTURE(unequal);
      const auto start = [&] {
        Engine engine = lively(friction, walls, unequal);
        if (kind % 4 >= 2) // by a descent in place of drag
          engine.descend();
        return engine;
      };
      Engine one = start();
      run(one, 50);
      CHECK(one.figures().contacts > 0);
      if (kind < 2) {
        CHECK((one.figures().sliding > 0) == (friction > 0));
        CHECK((one.figures().wall_contacts > 0) == walls);
      }
      for (std::size_t threads = kind < 2 ? 2u : 4u; threads <= 4; ++threads) {
        CAPTURE(threads);
        Engine many = start();
        many.set_threads(threads);
        CHECK(many.threads() == threads);
        run(many, 25);
        Engine resumed = reloaded(many);
        CHECK(resumed.threads() == 1);
        resumed.set_threads(5 - threads);
        run(many, 25);
        run(resumed, 25);
        check_same(one, many);
        check_same(one, resumed);
      }
    }
  }
}

TEST_CASE("threads come and go while an engine runs, and it may be moved") {
  Engine one = lively(0.2, false), other = lively(0.2, false);
  for (const std::size_t threads : {3u, 1u, 2u}) {
    other.set_threads(threads);
    run(one, 10);
    run(other, 10);
    Engine moved = std::move(other);
    other = std::move(moved);
  }
  check_same(one, other);
}

TEST_CASE("a small specimen takes one thread, and no engine takes none") {
  Engine engine(test::fcc(radius, 3, 2e-7), test::quartz(radius, 0.5));
  engine.set_threads(4);
  CHECK(engine.threads() == 1);
  CHECK_THROWS_AS(engine.set_threads(0), InvalidArgument);
}

TEST_CASE("a team calls its job once for each member, in each run") {
  for (const std::size_t members : {1u, 2u, 5u}) {
    Team team(members);
    REQUIRE(team.size() == members);
    std::vector<int> calls(members, 0);
    for (int round = 1; round <= 1000; ++round) {
      team.run([&](std::size_t member) { ++calls[member]; });
      CHECK(std::accumulate(calls.begin(), calls.end(), 0) == round * static_cast<int>(members));
    }
    CHECK(calls == std::vector<int>(members, 1000));
  }
}

TEST_CASE("a partition contains every pair once, and each chunk writes its own rows") {
  const Specimen state = test::fcc(radius, 11, 2e-7);
  const std::vector<Pair> pairs =
      neighbour_pairs(state.cell, state.position, 2.02 * radius, Images::periodic);
  const Partition parts = partition(pairs, state.grain_count());
  REQUIRE(parts.chunks.size() > 1);
  std::vector<int> writer(parts.rows, -1);
  std::vector<std::uint32_t> owner(parts.rows);
  std::iota(owner.begin(), owner.end(), 0u);
  for (const Addition& addition : parts.additions)
    owner[addition.row] = addition.grain;
  std::size_t next = 0;
  for (std::size_t c = 0; c < parts.chunks.size(); ++c) {
    const Chunk& chunk = parts.chunks[c];
    CHECK((chunk.pairs.end - chunk.pairs.begin) % block_size == 0);
    for (std::size_t k = chunk.pairs.begin; k < chunk.pairs.end; ++k) {
      const ListedPair& pair = parts.pairs[k];
      for (const std::uint32_t row : {pair.i().number(), pair.row().number()}) {
        REQUIRE((writer[row] == -1 || writer[row] == static_cast<int>(c)));
        writer[row] = static_cast<int>(c);
      }
      REQUIRE(owner[pair.row().number()] == pair.j().number());
      if (pair.image() == far_image)
        continue;
      REQUIRE((pairs[next].i == pair.i().number() && pairs[next].j == pair.j().number() &&
               pairs[next].image == pair.image().number()));
      ++next;
    }
    for (std::size_t k = chunk.additions.begin; k < chunk.additions.end; ++k) {
      const std::uint32_t grain = parts.additions[k].grain;
      REQUIRE((grain >= chunk.grains.begin && grain < chunk.grains.end));
    }
  }
  CHECK(next == pairs.size());
  CHECK(parts.additions.size() == parts.rows - state.grain_count());
}
