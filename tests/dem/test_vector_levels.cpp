// SPDX-License-Identifier: GPL-3.0-or-later
#include "../../src/dem/vector_level.hpp"

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <granum/core/error.hpp>
#include <granum/dem/engine.hpp>

#include "dem/lattice_state.hpp"

using namespace granum;
using namespace granum::dem;

namespace {

constexpr double radius = 0.5e-3;
constexpr contact::GrainMaterial grain{.shear_modulus = 30e9, .poisson_ratio = 0.15};

/// Sets a level, and the one that stood before at its end.
class LevelSet {
 public:
  explicit LevelSet(VectorLevel level) : before_(vector_level()) { set_vector_level(level); }
  ~LevelSet() { set_vector_level(before_); }
  LevelSet(const LevelSet&) = delete;
  LevelSet& operator=(const LevelSet&) = delete;

 private:
  VectorLevel before_;
};

struct Scene {
  std::string name;
  contact::PowerLaw law;
  double friction;
  bool walls;
};

std::vector<Scene> scenes() {
  const auto sphere = contact::PowerLaw::sphere(grain, radius);
  return {{"spheres", sphere, 0.2, false},
          {"spheres between walls", sphere, 0.2, true},
          {"frictionless spheres", sphere, 0, false},
          {"cones", contact::PowerLaw::cone(grain, 0.01), 0.2, false},
          {"flat punches", contact::PowerLaw::flat(grain, 1e-6), 0.2, false},
          {"alpha = 1.4", contact::PowerLaw::general(grain, 1.4, 20), 0.2, false}};
}

/// A lattice that is sheared until contacts slide, open and close.
Engine run(const Scene& scene, std::size_t& slid) {
  State state = test::fcc(radius, 3, 2e-7);
  for (std::size_t g = 0; g < state.grain_count(); ++g) {
    const double phase = static_cast<double>(g);
    state.velocity[g] = 1e-2 * Vec3{std::sin(5 * phase), std::sin(3 * phase + 1), std::cos(2 * phase)};
    state.angular_velocity[g] = 2 * Vec3{std::cos(phase), std::sin(7 * phase), std::cos(4 * phase)};
  }
  if (scene.walls)
    state.walls = Walls{.friction_coefficient = 0.3, .history = {}};
  Material material = test::quartz(radius, scene.friction);
  material.law = scene.law;
  Engine engine(std::move(state), material);
  for (int k = 0; k < 300; ++k) {
    const double way = k < 200 ? 2e-6 : -2e-6;
    engine.set_velocity_gradient(way / engine.time_step() * Mat3::diagonal(1, -1.5, 0.2));
    engine.step();
    slid += engine.figures().sliding;
  }
  return engine;
}

} // namespace

TEST_CASE("all vector levels of the engine give the same bits") {
  constexpr std::array levels{VectorLevel::avx2, VectorLevel::avx512};
  std::size_t compared = 0;
  for (const Scene& scene : scenes()) {
    CAPTURE(scene.name);
    const LevelSet plain(VectorLevel::baseline);
    std::size_t slid = 0;
    const Engine reference = run(scene, slid);
    CHECK(reference.figures().contacts > 0);
    CHECK((slid > 0) == (scene.friction > 0));
    for (const VectorLevel level : levels) {
      if (!runs_here(level))
        continue;
      CAPTURE(static_cast<int>(level));
      const LevelSet wide(level);
      const Engine engine = run(scene, slid);
      CHECK(engine.state() == reference.state());
      CHECK(engine.figures().stress == reference.figures().stress);
      CHECK(engine.figures().p_wave_modulus == reference.figures().p_wave_modulus);
      CHECK(engine.kinetic_energy() == reference.kinetic_energy());
      CHECK(engine.time_step() == reference.time_step());
      ++compared;
    }
  }
  if (runs_here(VectorLevel::avx2))
    CHECK(compared >= scenes().size());
  else
    MESSAGE("NOT COMPARED: this machine or build has the plain level only");
}

TEST_CASE("the engine takes the widest level that runs here, and none that does not") {
  for (const VectorLevel level : {VectorLevel::baseline, VectorLevel::avx2, VectorLevel::avx512}) {
    CAPTURE(static_cast<int>(level));
    if (runs_here(level))
      CHECK(static_cast<int>(vector_level()) >= static_cast<int>(level));
    else
      CHECK_THROWS_AS(set_vector_level(level), InvalidArgument);
  }
}
