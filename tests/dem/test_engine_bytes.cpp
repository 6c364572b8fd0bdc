// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <cstring>
#include <random>
#include <string>

#include <doctest/doctest.h>
#include <granum/core/error.hpp>
#include <granum/dem/engine.hpp>
#include <granum/dem/quasistatic.hpp>
#include <granum/dem/specimen.hpp>

#include "lattice_state.hpp"

using namespace granum;
using namespace granum::dem;

namespace {

using test::radius;

/// A lattice in motion: contacts open, close and slide.
Specimen lively(bool walls, double speed = 5e-3) {
  Specimen state = test::fcc(radius, 3, 2e-7);
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

TEST_CASE("a given damping is stored") {
  const Material material = test::quartz(radius, 0.5);
  Engine straight(lively(false), material);
  straight.set_damping(0);
  run(straight, 10);
  Engine resumed = reloaded(straight);
  run(straight, 10);
  run(resumed, 10);
  CHECK(resumed.state() == straight.state());
}

TEST_CASE("a given fraction of the time step is stored") {
  const Material material = test::quartz(radius, 0.5);
  Engine straight(lively(false), material);
  straight.set_time_step_fraction(0.3);
  run(straight, 10);
  Engine resumed = reloaded(straight);
  CHECK(resumed.time_step() == straight.time_step());
  run(straight, 100); // the time step is chosen anew on the way
  run(resumed, 100);
  CHECK(resumed.state() == straight.state());
  CHECK(resumed.time_step() == straight.time_step());
}

TEST_CASE("a state comes back equal, walls and memories included") {
  const Material material = test::quartz(radius, 0.5);
  Engine engine(lively(true), material);
  run(engine, 100);
  const Specimen state = engine.state();
  REQUIRE_FALSE(state.walls->history.empty());
  ByteWriter bytes;
  save_specimen(bytes, state);
  ByteReader reader(bytes.bytes(), "bytes");
  CHECK(load_specimen(reader) == state);
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

TEST_CASE("forged bytes are refused, or the engine continues with them within its own memory") {
  const Material material = test::quartz(radius, 0.5);
  std::mt19937_64 random(7);
  for (const bool walls : {false, true}) {
    Engine engine(lively(walls), material);
    run(engine, 20);
    ByteWriter written;
    engine.save(written);
    std::size_t refused = 0, taken = 0;
    for (int k = 0; k < 500; ++k) {
      std::string bytes = written.bytes();
      const std::array<std::uint64_t, 7> values{
          0, 1, ~std::uint64_t{0}, 0x7fffffff7fffffff, 0x7ff8000000000000, 0x7fefffffffffffff, random()};
      const std::uint64_t value = values[random() % values.size()];
      const std::size_t width = random() % 2 == 0 ? 4 : 8;
      const std::size_t at = random() % (bytes.size() / width) * width;
      std::memcpy(bytes.data() + at, &value, width); // the sanitizers see what is read or written amiss
      ByteReader reader(bytes, "forged");
      try {
        Engine forged = Engine::load(reader, material);
        run(forged, 2);
        (void)forged.state();
        ++taken;
      } catch (const FileError&) {
        ++refused;
      } catch (const InvalidArgument&) {
        ++refused;
      }
    }
    CHECK(taken > 0);
    CHECK(refused > 0);
  }
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
    CHECK_THROWS_WITH_AS((void)load_specimen(reader), "bad: contains an impossible state of its grains",
                         FileError);
  };
  refused([](Specimen& s) { s.position.pop_back(); });
  refused([](Specimen& s) { s.position.front().x = NAN; });
  refused([](Specimen& s) { s.position.front().y = 1e9; });
  refused([](Specimen& s) { s.radius = 0; });
  refused([](Specimen& s) { s.cell = Mat3{}; });
  refused([](Specimen& s) { s.cell = 1e6 * s.cell; });
  refused([](Specimen& s) { s.history.push_back({.i = 1, .j = 100000, .tangential_force = {}}); });
  refused([](Specimen& s) { s.walls->history.push_back({.grain = 0, .wall = 6, .tangential_force = {}}); });
  refused([](Specimen& s) { s.velocity.back().z = INFINITY; });
}
