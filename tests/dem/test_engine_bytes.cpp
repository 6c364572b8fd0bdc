// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <doctest/doctest.h>
#include <granum/core/error.hpp>
#include <granum/dem/engine.hpp>
#include <granum/dem/minimise.hpp>
#include <granum/dem/state_bytes.hpp>

#include "dem/lattice_state.hpp"

using namespace granum;
using namespace granum::dem;

namespace {

constexpr double radius = 0.5e-3;

/// A lattice in motion: contacts open, close and slide.
State lively(bool walls, double speed = 5e-3) {
  State state = test::fcc(radius, 3, 2e-7);
  for (std::size_t g = 0; g < state.grain_count(); ++g) {
    const double phase = static_cast<double>(g);
    state.velocity[g] = speed * Vec3{std::sin(5 * phase), std::sin(3 * phase + 1), std::cos(2 * phase)};
  }
  if (walls)
    state.walls = Walls{.friction_coefficient = 0.3, .history = {}};
  return state;
}

void run(Engine& engine, int steps, double scale = 1) {
  for (int k = 0; k < steps; ++k) {
    const double rate = scale * (engine.steps() % 300 < 150 ? -2 : 1);
    engine.set_velocity_gradient(Mat3::diagonal(rate, rate / 2, -rate));
    engine.step();
  }
}

Engine reloaded(const Engine& engine) {
  ByteWriter bytes;
  engine.save(bytes);
  ByteReader reader(bytes.bytes(), "bytes");
  Engine again = Engine::load(reader, engine.material());
  CHECK(reader.empty());
  return again;
}

} // namespace

TEST_CASE("2 n steps are n steps, saved, loaded, and n more, to the bit") {
  for (const bool walls : {false, true})
    for (const double friction : {0.5, 0.0})
      for (const int n : {0, 1, 49, 137, 700}) {
        CAPTURE(walls);
        CAPTURE(friction);
        CAPTURE(n);
        const Material material = test::quartz(radius, friction);
        Engine straight(lively(walls), material);
        run(straight, n);
        Engine resumed = reloaded(straight);
        CHECK(resumed.state() == straight.state());
        run(straight, n + 60);
        run(resumed, n + 60);
        CHECK(resumed.state() == straight.state());
        CHECK(resumed.steps() == straight.steps());
        CHECK(resumed.time_step() == straight.time_step());
        CHECK(resumed.figures().stress == straight.figures().stress);
        CHECK(resumed.unbalanced_force_ratio() == straight.unbalanced_force_ratio());
        CHECK(resumed.wall_forces().force == straight.wall_forces().force);
      }
}

TEST_CASE("the pair list is renewed at the same step where the strain of the cell calls for it") {
  const Material material = test::quartz(radius, 0.5);
  Engine straight(lively(false, 1e-6), material);
  run(straight, 200, 8);
  Engine resumed = reloaded(straight);
  run(straight, 1500, 8);
  run(resumed, 1500, 8);
  CHECK(resumed.state() == straight.state());
}

TEST_CASE("a damping that was set goes along") {
  const Material material = test::quartz(radius, 0.5);
  Engine straight(lively(false), material);
  straight.set_damping(0);
  run(straight, 10);
  Engine resumed = reloaded(straight);
  run(straight, 10);
  run(resumed, 10);
  CHECK(resumed.state() == straight.state());
}

TEST_CASE("a state comes back equal, walls and memories included") {
  const Material material = test::quartz(radius, 0.5);
  Engine engine(lively(true), material);
  run(engine, 100);
  const State state = engine.state();
  REQUIRE_FALSE(state.walls->history.empty());
  ByteWriter bytes;
  save_state(bytes, state);
  ByteReader reader(bytes.bytes(), "bytes");
  CHECK(load_state(reader) == state);
  CHECK(reader.empty());
}

TEST_CASE("an engine is not loaded for another material, nor from part of its bytes") {
  const Material material = test::quartz(radius, 0.5);
  ByteWriter bytes;
  Engine(lively(false), material).save(bytes);
  Material other = material;
  other.friction_coefficient = 0.4;
  ByteReader reader(bytes.bytes(), "run.checkpoint");
  CHECK_THROWS_WITH_AS((void)Engine::load(reader, other),
                       "run.checkpoint: was written for grains of another material or contact law",
                       FileError);
  ByteReader cut(std::string_view(bytes.bytes()).substr(0, bytes.bytes().size() / 2), "cut");
  CHECK_THROWS_AS((void)Engine::load(cut, material), FileError);
}
