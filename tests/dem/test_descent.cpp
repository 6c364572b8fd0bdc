// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/dem/engine.hpp>
#include <granum/dem/quasistatic.hpp>

#include "lattice_state.hpp"
#include "unit.hpp"

using namespace granum::dem;

namespace {

using test::radius;
constexpr double lattice_overlap = 2e-7;

/// Nothing slides.
Material sticking() { return test::quartz(radius, std::numeric_limits<double>::infinity()); }

/// A lattice, every centre of which is a little out of its place; unequal grains differ by a part of the
/// overlap.
Specimen shaken(int edges, bool unequal, bool walls) {
  Specimen state = test::fcc(radius, edges, lattice_overlap);
  for (std::size_t g = 0; g < state.grain_count(); ++g) {
    state.position[g] += 0.05 * lattice_overlap * test::scatter(g);
    if (unequal)
      state.size.push_back(1 + 0.1 * lattice_overlap / radius * std::sin(7 * static_cast<double>(g)));
  }
  if (walls) { // the outermost layers overlap with them as grains do
    const double room = radius - lattice_overlap / 2 - std::sqrt(2.0) / 4 * (2 * radius - lattice_overlap);
    state.cell = state.cell + 2 * room * Mat3::identity();
    for (Vec3& x : state.position)
      x += {room, room, room};
    state.walls = test::walls(0.3);
  }
  return state;
}

/// Two grains that overlap, and one that touches nothing.
Specimen pair_and_one() {
  Specimen state = test::pair_state(lattice_overlap);
  state.position.push_back({1e-3, 1e-3, 1e-3});
  state.velocity.resize(3);
  state.angular_velocity.resize(3);
  return state;
}

} // namespace

TEST_CASE("a descent comes to the rest that drag comes to") {
  for (const bool unequal : {false, true})
    for (const bool walls : {false, true})
      for (const bool smooth : {false, true}) {
        CAPTURE(unequal);
        CAPTURE(walls);
        CAPTURE(smooth);
        // A contact that unloads on the way sheds part of its tangential force, on each way a little else.
        const double near = smooth ? 1e-6 : 0.1, same = smooth ? 1e-8 : 5e-3;
        const Material material = smooth ? test::quartz(radius, 0) : sticking();
        const QuasistaticOptions tight{.force_tolerance = 1e-10, .max_steps = 20000};
        Engine drag(shaken(3, unequal, walls), material), descent(shaken(3, unequal, walls), material);
        REQUIRE(deform(drag, Mat3{}, 0, tight).converged());
        descent.descend();
        REQUIRE(deform(descent, Mat3{}, 0, tight).converged());
        const Specimen one = drag.state(), other = descent.state();
        double farthest = 0;
        for (std::size_t g = 0; g < one.grain_count(); ++g)
          farthest = std::max(
              farthest, norm((one.position[g] - one.position[0]) - (other.position[g] - other.position[0])));
        CHECK(farthest < near * lattice_overlap);
        for (int axis = 0; axis < 3; ++axis)
          CHECK(descent.figures().stress(axis, axis) == relative(drag.figures().stress(axis, axis), same));
      }
}

TEST_CASE("in a descent all stop where forces do no work, and a grain that touches nothing stops") {
  Specimen state = pair_and_one();
  const double speed = 1e-6;
  state.velocity = {{speed, 0, 0}, {-speed, 0, 0}, {0, 0, speed}};
  Engine climbing(state, sticking());
  climbing.descend();
  // The force turns grains as slow as these in the first step.
  climbing.step();
  CHECK(climbing.kinetic_energy() > 0);
  CHECK(climbing.state().velocity[0].x < 0);
  CHECK(climbing.state().velocity[2] == Vec3{});

  state.velocity = {{1, 0, 0}, {-1, 0, 0}, {0, 0, speed}};
  Engine stopped(state, sticking());
  stopped.set_time_step_fraction(0.01);
  stopped.descend();
  stopped.step();
  CHECK(stopped.kinetic_energy() == 0);
}

TEST_CASE("a descent turns a tenth of the velocities towards the forces") {
  // One pair: force and velocity are across each other, so that turning shows at once.
  Specimen state = pair_and_one();
  state.velocity = {{0, 1, 0}, {0, -1, 0}, {}};
  Engine free(state, test::quartz(radius, 0)), turned(state, test::quartz(radius, 0));
  free.set_damping(0);
  free.step();
  turned.descend();
  turned.step();
  const Vec3 before = free.state().velocity[0], after = turned.state().velocity[0];
  CHECK(std::abs(after.y) == relative(0.9 * std::abs(before.y), 0.01));
  CHECK(after.x / before.x > 1);
}

TEST_CASE("a drag that is set ends a descent") {
  Engine engine(shaken(3, false, false), sticking()), other(shaken(3, false, false), sticking());
  engine.descend();
  for (Engine* e : {&engine, &other}) {
    e->set_damping(0);
    for (int k = 0; k < 20; ++k)
      e->step();
  }
  CHECK(engine.state() == other.state());
}
