// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/dem/engine.hpp>
#include <granum/dem/quasistatic.hpp>
#include <granum/dem/specimen.hpp>

#include "lattice_state.hpp"
#include "thresholds.hpp"
#include "unit.hpp"

using namespace granum::dem;

namespace {

using test::radius;
using test::reloaded;

/// A lattice in motion: contacts open, close and slide.
Specimen lively(bool walls, double speed = 5e-3) {
  Specimen state = test::fcc(radius, 3, 2e-7);
  for (std::size_t g = 0; g < state.grain_count(); ++g)
    state.velocity[g] = speed * test::scatter(g);
  if (walls)
    state.walls = test::walls(0.3);
  return state;
}

void run(Engine& engine, int steps, double scale = 1) {
  for (int k = 0; k < steps; ++k) {
    const double rate = scale * (engine.steps() % 300 < 150 ? -2 : 1);
    engine.set_velocity_gradient(Mat3::diagonal(rate, rate / 2, -rate));
    engine.step();
  }
}

} // namespace

TEST_CASE("2 n steps are n steps, saved, loaded, and n more, to the bit") {
  struct Start {
    bool walls, by_default;
    double friction;
  };
  for (const Start& start : {Start{false, true, 0.5}, Start{false, true, 0}, Start{true, true, 0.5},
                             Start{true, true, 0}, Start{false, false, 0.5}})
    for (const int n : {0, 1, 137, 700}) {
      CAPTURE(start.walls);
      CAPTURE(start.by_default);
      CAPTURE(start.friction);
      CAPTURE(n);
      Engine straight(lively(start.walls), test::quartz(radius, start.friction));
      if (!start.by_default) {
        straight.set_damping(0);
        straight.set_time_step_fraction(0.3);
      }
      run(straight, n);
      Engine resumed = reloaded(straight);
      CHECK(resumed.state() == straight.state());
      CHECK(resumed.time_step() == straight.time_step());
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

TEST_CASE("an engine is not loaded for another material, nor from part of its bytes") {
  const Material material = test::quartz(radius, 0.5);
  ByteWriter bytes;
  Engine(lively(false), material).save(bytes);
  Material other = material;
  other.friction_coefficient = 0.4;
  ByteReader reader(bytes.bytes(), "run.checkpoint");
  CHECK_THROWS_WITH_AS((void)Engine::load(reader, other), doctest::Contains("run.checkpoint"), FileError);
  ByteReader cut(std::string_view(bytes.bytes()).substr(0, bytes.bytes().size() / 2), "cut");
  CHECK_THROWS_AS((void)Engine::load(cut, material), FileError);
}

TEST_CASE("a state or an engine of impossible numbers is refused as its file") {
  const Material material = test::quartz(radius, 0.5);
  const Specimen sound = Engine(lively(true), material).state();
  const auto refused = [&](auto change) {
    Specimen bad = sound;
    change(bad);
    ByteWriter bytes;
    save_specimen(bytes, bad);
    ByteReader reader(bytes.bytes(), "bad");
    CHECK_THROWS_WITH_AS((void)load_specimen(reader), doctest::Contains("bad"), FileError);
  };
  const auto limit = [&](double at, auto change) {
    check_threshold(at, [&](double value) {
      Specimen state = sound;
      change(state, value);
      ByteWriter bytes;
      save_specimen(bytes, state);
      ByteReader reader(bytes.bytes(), "bytes");
      return refusals([&] { (void)load_specimen(reader); });
    });
  };
  const auto filled = [](Specimen& s, double share) { // of the cubes of the radii over the cell
    const double cubes = static_cast<double>(s.grain_count()) * std::pow(s.radius, 3);
    s.cell = std::cbrt(cubes / share / determinant(s.cell)) * s.cell;
  };
  limit(1e-4, filled);
  limit(1, filled);
  limit(1e-6, [](Specimen& s, double size) {
    s.size.assign(s.grain_count(), 1);
    s.size[3] = size;
  });
  for (const int axis : {0, 1, 2})
    limit(1e3, [=](Specimen& s, double cells) { s.position.front()[axis] = -cells * s.cell(axis, axis); });
  refused([](Specimen& s) { s.position.pop_back(); });
  refused([](Specimen& s) { s.position.front().x = NAN; });
  refused([](Specimen& s) { s.position.front().y = 1e9; });
  refused([](Specimen& s) { s.radius = 0; });
  refused([](Specimen& s) { s.cell = Mat3{}; });
  refused([](Specimen& s) { s.cell = 1e6 * s.cell; });
  refused([](Specimen& s) { s.history.push_back({.i = 1, .j = 100000, .tangential_force = {}}); });
  refused([](Specimen& s) { s.walls->history.push_back({.grain = 0, .wall = 6, .tangential_force = {}}); });
  refused([](Specimen& s) { s.velocity.back().z = INFINITY; });
  for (const double size : {0.0, double{NAN}, double{INFINITY}, 1e9})
    refused([size](Specimen& s) {
      s.size.assign(s.grain_count(), 1);
      s.size[3] = size;
    });
  refused([](Specimen& s) { s.size.assign(s.grain_count() - 1, 1); });
}
