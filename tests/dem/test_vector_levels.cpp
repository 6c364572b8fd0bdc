// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/dem/engine.hpp>
#include <granum/dem/quasistatic.hpp>

#include "lattice_state.hpp"
#include "unit.hpp"
#include "vector_levels.hpp"

using namespace granum::dem;

namespace {

using test::radius;
constexpr contact::GrainMaterial grain{.shear_modulus = 30e9, .poisson_ratio = 0.15};

struct Scene {
  std::string name;
  contact::NormalLaw law;
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
          {"alpha = 1.4", contact::PowerLaw::general(grain, 1.4, 20), 0.2, false},
          {"rough spheres", contact::RoughSphere(grain, radius, 2e-8), 0.2, false},
          {"rough spheres between walls", contact::RoughSphere(grain, radius, 2e-8), 0.2, true}};
}

struct Run {
  Engine engine;
  std::size_t slid; ///< sliding contacts, added up over the steps
};

/// A lattice that is sheared until contacts slide, open and close. All laws bear one force at first: an
/// overlap of a few u0 is next to no force of rough spheres, and velocities that hardly shake the others make
/// a gas of them, whose collisions take a change of 1e-15 of a radius to 1e-6 of the stress at one
/// and the same level.
Run run(const Scene& scene, VectorLevel level) {
  const test::LevelSet at(level);
  constexpr double force = 0.067;
  Specimen state = test::fcc(radius, 3, scene.law.overlap(force));
  test::set_in_motion(state);
  if (scene.walls)
    state.walls = test::walls(0.3);
  Material material = test::quartz(radius, scene.friction);
  material.law = scene.law;
  Run out{Engine(std::move(state), material), 0};
  Engine& engine = out.engine;
  for (int k = 0; k < 300; ++k) {
    const double way = k < 200 ? 2e-6 : -2e-6;
    engine.set_velocity_gradient(way / engine.time_step() * Mat3::diagonal(1, -1.5, 0.2));
    engine.step();
    out.slid += engine.figures().sliding;
  }
  return out;
}

} // namespace

TEST_CASE("vector levels with fused multiply-adds give the same bits in the engine and the minimiser") {
  if (!runs_here(VectorLevel::avx512)) {
    MESSAGE("NOT COMPARED: this machine or build has no second level with fused multiply-adds");
    return;
  }
  for (const Scene& scene : scenes()) {
    CAPTURE(scene.name);
    const Run narrow = run(scene, VectorLevel::avx2), wide = run(scene, VectorLevel::avx512);
    CHECK(wide.engine.figures().contacts > 0);
    CHECK((wide.slid > 0) == (scene.friction > 0));
    CHECK(wide.slid == narrow.slid);
    CHECK(wide.engine.state() == narrow.engine.state());
    CHECK(wide.engine.figures().stress == narrow.engine.figures().stress);
    CHECK(wide.engine.figures().p_wave_modulus == narrow.engine.figures().p_wave_modulus);
    CHECK(wide.engine.kinetic_energy() == narrow.engine.kinetic_energy());
    CHECK(wide.engine.time_step() == narrow.engine.time_step());
  }
  for (const bool walls : {false, true}) {
    CAPTURE(walls);
    const auto minimised = [&](VectorLevel level) {
      const test::LevelSet at(level);
      Specimen state = test::fcc(radius, 3, 0.03 * radius);
      for (std::size_t g = 0; g < state.grain_count(); ++g)
        state.position[g] += 0.05 * radius * test::scatter(g);
      if (walls)
        state.walls = Walls{};
      const RelaxReport report = minimise_enthalpy(state, contact::PowerLaw::sphere(grain, radius), 1e5);
      CHECK(report.converged);
      return std::pair{state, report.steps};
    };
    CHECK(minimised(VectorLevel::avx2) == minimised(VectorLevel::avx512));
  }
}

TEST_CASE("the baseline differs from the other vector levels by round-off") {
  if (vector_level() == VectorLevel::baseline) {
    MESSAGE("NOT COMPARED: this machine or build has the plain level only");
    return;
  }
  for (const Scene& scene : scenes()) {
    CAPTURE(scene.name);
    const Run plain = run(scene, VectorLevel::baseline), fused = run(scene, vector_level());
    CHECK(plain.engine.figures().contacts == fused.engine.figures().contacts);
    CHECK(plain.engine.time_step() == doctest::Approx(fused.engine.time_step()).epsilon(1e-10));
    const Mat3 stress = fused.engine.figures().stress;
    for (int row = 0; row < 3; ++row)
      for (int col = 0; col < 3; ++col)
        CHECK(std::abs(plain.engine.figures().stress(row, col) - stress(row, col)) < 1e-9 * trace(stress));
    CHECK(plain.engine.kinetic_energy() == doctest::Approx(fused.engine.kinetic_energy()).epsilon(1e-9));
  }
}
