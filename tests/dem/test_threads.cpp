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
using test::reloaded;
using test::shear_on;

/// A lattice of 4 * 11^3 grains in motion, equal or of sizes from 1/2 to 1.
Engine lively(double friction, bool walls, bool unequal = false) {
  Specimen state = test::fcc(radius, 11, 2e-7 + (unequal ? 0.5 * radius : 0));
  test::set_in_motion(state);
  for (std::size_t g = 0; unequal && g < state.grain_count(); ++g)
    state.size.push_back(0.75 + 0.25 * std::sin(13 * static_cast<double>(g)));
  if (walls)
    state.walls = test::walls(0.3);
  return {std::move(state), test::quartz(radius, friction)};
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

} // namespace

TEST_CASE("any number of threads gives the same bits, before and after save and load") {
  for (int kind = 0; kind < 8; ++kind) {
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
      shear_on(one, 50);
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
        shear_on(many, 25);
        Engine resumed = reloaded(many);
        CHECK(resumed.threads() == 1);
        resumed.set_threads(5 - threads);
        shear_on(many, 25);
        shear_on(resumed, 25);
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
    shear_on(one, 10);
    shear_on(other, 10);
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

TEST_CASE("a listed pair keeps its four places apart") {
  constexpr auto last = static_cast<std::uint32_t>(RowPlace::most_rows);
  CHECK(RowPlace::of(last + 1).number() != last + 1);
  for (const std::uint32_t number : {0u, 12345u, last}) {
    const RowPlace other = RowPlace::of(last - number);
    const ListedPair pair(RowPlace::of(number), other, RowPlace::of(number / 2), RowPlace::of(number / 3));
    CHECK(pair.i().number() == number);
    CHECK(pair.j() == other);
    CHECK(pair.image().number() == number / 2);
    CHECK(pair.row().number() == number / 3);
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
