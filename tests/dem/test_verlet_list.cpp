// SPDX-License-Identifier: GPL-3.0-or-later
// A list taken from a wider one against a search through all grains, pair by pair and in order, while grains
// wander through the faces of a cell that is strained.
#include "dem/sweep/verlet_list.hpp"

#include <random>

#include "unit.hpp"

using namespace granum::dem;

namespace {

constexpr double skin = 0.1, wide_skin = 0.6;

Vec3 random_place(std::mt19937_64& random) {
  Vec3 s;
  for (int axis = 0; axis < 3; ++axis)
    s[axis] = static_cast<double>(random() >> 11) * 0x1p-53;
  return s;
}

/// Grains of radius 1 (times their sizes) as dense as in a packing, anywhere.
Specimen scattered(const Mat3& shape, std::size_t grains, unsigned seed, bool unequal) {
  std::mt19937_64 random(seed);
  Specimen state;
  state.radius = 1;
  const double volume = 7.0 * static_cast<double>(grains);
  state.cell = std::cbrt(volume / determinant(shape)) * shape;
  for (std::size_t g = 0; g < grains; ++g) {
    state.position.push_back(state.cell * random_place(random));
    if (unequal)
      state.size.push_back(0.6 + 0.8 * random_place(random).x);
  }
  return state;
}

/// What a search finds for the state as it is.
std::vector<Pair> searched(const Specimen& state, double skin_of_list = skin) {
  std::vector<double> radii;
  for (std::size_t g = 0; g < state.grain_count(); ++g)
    radii.push_back(state.radius_of(g));
  if (state.size.empty())
    return neighbour_pairs(state.cell, state.position, 2 + skin_of_list, images(state));
  return neighbour_pairs(state.cell, state.position, radii, skin_of_list, images(state));
}

/// All grains by up to `step` on each axis, the cell and they by a little strain.
void wander(Specimen& state, std::mt19937_64& random, double step) {
  const Mat3 stretch{{{1.001, 0.0005, 0}, {0, 0.9995, 0}, {0, -0.0003, 1}}};
  state.cell = stretch * state.cell;
  for (Vec3& x : state.position)
    x = stretch * x + step * (2 * random_place(random) - Vec3{1, 1, 1});
}

const Mat3 cube = Mat3::diagonal(1, 1, 1);
const Mat3 skew{{{1.2, 0.3, -0.2}, {0, 1.1, 0.25}, {0.1, 0, 1.3}}};

} // namespace

TEST_CASE("lists filtered from a wider one contain the pairs of a search, in its order, with any skins") {
  for (const Mat3& shape : {cube, skew})
    for (const bool unequal : {false, true})
      for (const int kind : {0, 1, 2}) { // periodic, between walls, with another skin for each list
        CAPTURE(unequal);
        CAPTURE(kind);
        Specimen state = scattered(shape, 500, 3, unequal);
        if (kind == 1)
          state.walls = Walls{};
        VerletList list(state, skin, wide_skin);
        std::mt19937_64 random(11);
        constexpr std::size_t builds = 60;
        for (std::size_t b = 0; b < builds; ++b) {
          const double now = kind == 2 ? std::array{0.005, 0.1, 0.03, 0.3}[b % 4] : skin;
          if (kind == 2)
            list.set_skin(now);
          CHECK(list.skin() == now);
          list.build(state);
          REQUIRE(list.pairs() == searched(state, now));
          CHECK(list.valid({.farthest = 0.49 * now, .strain = 0}));
          CHECK_FALSE(list.valid({.farthest = 0.51 * now, .strain = 0}));
          wander(state, random, 0.02);
        }
        CHECK(list.searches() > 2);
        CHECK(list.searches() < (kind == 2 ? builds / 2 : builds / 3));
      }
}

TEST_CASE("two grains that come from afar, straight at each other, are listed in time") {
  for (const bool by_strain : {false, true})
    for (const double later_skin : {skin, 0.3}) {
      Specimen state;
      state.radius = 1;
      state.cell = Mat3::diagonal(10, 10, 10);
      state.position = {{5 - 1.3005, 5, 5}, {5 + 1.3005, 5, 5}}; // just not in the wider list
      VerletList list(state, skin, wide_skin);
      list.build(state);
      list.set_skin(later_skin);
      for (int b = 0; b < 60; ++b) {
        list.build(state);
        REQUIRE(list.pairs() == searched(state, later_skin));
        if (by_strain) {
          const Mat3 squeeze = Mat3::diagonal(0.995, 1, 1);
          state.cell = squeeze * state.cell;
          for (Vec3& x : state.position)
            x = squeeze * x;
        } else {
          state.position[0].x += 0.005;
          state.position[1].x -= 0.005;
        }
      }
      CHECK(list.pairs().size() == 1);
      CHECK(list.searches() < 15);
    }
}

TEST_CASE("without a wider skin, in a cell too narrow for one and after a leap each list is searched") {
  Specimen state = scattered(cube, 300, 7, false);
  VerletList plain(state, skin);
  Specimen few = scattered(cube, 14, 7, false); // 4.6 wide: twice 2.1 fit, twice 2.6 do not
  VerletList narrow(few, skin, wide_skin);
  Specimen leaping = state;
  VerletList leap(leaping, skin, wide_skin);
  std::mt19937_64 random(13);
  for (std::size_t b = 1; b <= 5; ++b) {
    plain.build(state);
    CHECK(plain.searches() == b);
    narrow.build(few);
    CHECK(narrow.searches() == b);
    CHECK(narrow.pairs() == searched(few));
    leap.build(leaping);
    CHECK(leap.searches() == b);
    CHECK(leap.pairs() == searched(leaping));
    wander(leaping, random, 3);
  }
}

TEST_CASE("a grain that flew off to nowhere does not spoil the lists of the others") {
  for (const double nowhere : {1e300, std::numeric_limits<double>::quiet_NaN()}) {
    Specimen state = scattered(cube, 300, 9, false);
    VerletList list(state, skin, wide_skin);
    for (int b = 0; b < 3; ++b)
      list.build(state);
    state.position[17].y = nowhere;
    for (int b = 0; b < 3; ++b) {
      list.build(state);
      CHECK(list.pairs() == searched(state));
    }
  }
}
