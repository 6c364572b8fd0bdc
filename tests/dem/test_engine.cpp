// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/contact/rough_sphere.hpp>
#include <granum/dem/engine.hpp>

#include <granum/packing/forces.hpp>

#include "lattice_state.hpp"
#include "unit.hpp"

using namespace granum::dem;

namespace {

using test::pair_state;
using test::radius;

} // namespace

TEST_CASE("Coulomb's limit is satisfied at every contact, and sliding is counted") {
  const Material material = test::quartz(radius, 0.3);
  Specimen state = pair_state(1e-7);
  state.velocity = {{0, 0, 0}, {0, 0.05, 0}};
  Engine engine(state, material);
  std::size_t sliding = 0;
  for (int k = 0; k < 50; ++k) {
    engine.step();
    sliding += engine.figures().sliding;
    for (const packing::Contact& c : contact_network(engine.state(), material).contacts) {
      // The overlap is a difference of lengths: some units in the last place of the diameter.
      const double round_off = 8 * std::numeric_limits<double>::epsilon() * 2 * radius / c.overlap;
      CHECK(norm(c.tangential_force) <= 0.3 * c.normal_force * (1 + round_off));
    }
  }
  CHECK(sliding > 0);
}

TEST_CASE("the figures of a step are those of its contacts, between walls and without") {
  for (const bool walls : {false, true}) {
    CAPTURE(walls);
    const Material material = test::quartz(radius, 0.5);
    Specimen start = test::fcc(radius, 3, 2e-7);
    if (walls)
      start.walls = test::walls(0.3);
    test::set_in_motion(start);
    Engine engine(start, material);
    for (int k = 0; k < 20; ++k)
      engine.step();
    const packing::Assembly assembly = contact_network(engine.state(), material);
    double stiffness = 0, forces = 0, unbalanced = 0, touching = 0;
    for (const packing::Contact& c : assembly.contacts) {
      stiffness += c.normal_stiffness * dot(c.branch, c.branch);
      forces += c.normal_force;
    }
    for (const packing::Contact& c : assembly.wall_contacts)
      forces += c.normal_force;
    for (const packing::Residual& rest : residuals(assembly)) {
      const double size = std::hypot(norm(rest.force), norm(rest.moment) / radius);
      unbalanced += size;
      touching += size > 0;
    }
    const StepFigures& figures = engine.figures();
    const double all = static_cast<double>(assembly.contacts.size() + assembly.wall_contacts.size());
    CHECK(figures.contacts == assembly.contacts.size());
    CHECK(figures.wall_contacts == assembly.wall_contacts.size());
    CHECK(figures.mean_normal_force == relative(forces / all, 1e-9));
    CHECK(engine.unbalanced_force_ratio() == relative(unbalanced / touching / (forces / all), 1e-3));
    if (!walls) {
      CHECK(figures.p_wave_modulus ==
            relative(stiffness * (1.0 / 5 + 2.0 / 15 * material.tangential_ratio) / assembly.volume(), 1e-9));
      const Mat3 stress = contact_stress(assembly).tensor;
      for (int axis = 0; axis < 3; ++axis) {
        CHECK(figures.stress(axis, axis) == relative(stress(axis, axis), 1e-6));
        CHECK(figures.boundary_stress[axis] == figures.stress(axis, axis));
      }
    }
  }
}

TEST_CASE("velocities follow from forces with drag, which is that of the lowest frequency in the motion") {
  const Material material = test::quartz(radius, 0);
  for (const std::vector<double>& size : {std::vector<double>{}, {1, 0.6}})
    for (const double fixed : {-1.0, 0.0, 2e4}) {
      CAPTURE(fixed);
      Specimen state = pair_state(1e-7, size);
      state.velocity = {{1e-3, 2e-4, 0}, {-3e-3, 0, 1e-4}};
      Engine engine(state, material);
      if (fixed >= 0)
        engine.set_damping(fixed);
      const auto mass = [&](std::size_t g) { // of both together, as the sizes
        const double one = material.density * 4 / 3 * std::numbers::pi * std::pow(radius, 3);
        return size.empty() ? one : one * (1 + std::pow(size[1], 3)) * size[g] / (1 + size[1]);
      };
      const auto force_on = [&](const Specimen& of, std::size_t g) { // of two grains that touch, or do not
        const packing::Assembly assembly = contact_network(of, material);
        const Vec3 f = assembly.contacts.empty() ? Vec3{} : force(assembly.contacts[0]);
        return g == 0 ? -f : f;
      };
      for (int k = 0; k < 12; ++k) {
        const Specimen before = engine.state();
        const double dt = engine.time_step();
        engine.step();
        const Specimen after = engine.state();
        double work = 0, twice_kinetic = 0;
        for (const std::size_t g : {0U, 1U}) {
          work += dot(force_on(before, g) - force_on(after, g), before.velocity[g]);
          twice_kinetic += mass(g) * dot(before.velocity[g], before.velocity[g]);
        }
        const double damping =
            fixed >= 0
                ? fixed
                : std::clamp(2 * std::sqrt(std::max(0.0, work / (dt * twice_kinetic))), 2e-4 / dt, 0.5 / dt);
        const double drag = damping * dt / 2;
        for (const std::size_t g : {0U, 1U}) {
          const Vec3 expected =
              (1 / (1 + drag)) * ((1 - drag) * before.velocity[g] + dt / mass(g) * force_on(after, g));
          CHECK(norm(after.velocity[g] - expected) < 1e-6 * (norm(expected) + 1e-4));
        }
        CHECK(engine.kinetic_energy() == relative((mass(0) * dot(after.velocity[0], after.velocity[0]) +
                                                   mass(1) * dot(after.velocity[1], after.velocity[1])) /
                                                      2,
                                                  1e-9));
      }
    }
}

TEST_CASE("the time step is chosen anew where the stiffness has grown by a tenth, or after a hundred steps") {
  const Material material = test::quartz(radius, 0);
  const double overlap = 2e-7;
  for (const double growth : {0.5, 1e-3}) { // of all overlaps in fifty steps
    Engine engine(test::fcc(radius, 3, overlap), material);
    const double strain = growth * overlap / (50 * 2 * radius);
    double chosen = material.law.stiffness_at_overlap(overlap);
    int changes = 0;
    for (int k = 1; k <= 110; ++k) {
      const double before = engine.time_step();
      engine.set_velocity_gradient(-strain / before * Mat3::identity());
      engine.step();
      const double now = contact_network(engine.state(), material).contacts.at(0).normal_stiffness;
      const bool changed = engine.time_step() != before;
      CHECK(changed == (now > 1.1 * chosen || k == 100));
      chosen = changed ? now : chosen;
      changes += changed;
    }
    CHECK(changes >= 1);
  }
}

TEST_CASE("a tangential force shrinks with its stiffness when the contact unloads") {
  const Material material = test::quartz(radius, std::numeric_limits<double>::infinity());
  const double overlap = 1e-7;
  Specimen state = pair_state(overlap);
  const double k_t = material.tangential_ratio * material.law.stiffness_at_overlap(overlap);
  state.history = {{0, 1, {0, 1e-4, 0}, k_t}};
  // Apart by a hundredth of the overlap in one step, straight along the normal.
  Engine still(state, material);
  state.velocity[1] = {0.01 * overlap / still.time_step(), 0, 0};
  Engine engine(state, material);
  engine.set_damping(0);
  engine.step();
  const packing::Contact contact = contact_network(engine.state(), material).contacts.at(0);
  CHECK(contact.overlap == relative(0.99 * overlap, 1e-8));
  CHECK(contact.tangential_force.y == relative(1e-4 * std::sqrt(0.99), 1e-8));
}

TEST_CASE("the chosen time step stays below the stability limit of a stiff, regular packing") {
  // The highest frequency of the lattice shows as growth when the step is too long: give a random kick and
  // watch the energy for many steps without damping.
  const Material material = test::quartz(radius, std::numeric_limits<double>::infinity());
  Specimen state = test::fcc(radius, 3, 2e-7);
  for (std::size_t g = 0; g < state.grain_count(); ++g)
    state.velocity[g] = 1e-6 * test::scatter(g);
  Engine engine(state, material);
  engine.set_damping(0);
  const double start = engine.kinetic_energy();
  double largest = 0;
  for (int k = 0; k < 5000; ++k) {
    engine.step();
    largest = std::max(largest, engine.kinetic_energy());
  }
  CHECK(largest < 2 * start);
  CHECK(engine.finite());
}

TEST_CASE("grains apart have the time step of an overlap of 1e-4 R, rough ones no longer one than at first "
          "contact") {
  Material material = test::quartz(radius, 0.5);
  const auto step_at = [&](double stiffness, double size) {
    const double both = 4.0 / 3 * std::numbers::pi * material.density * (1 + std::pow(size, 3)) *
                        std::pow(radius, 3),
                 mass = both * size / (1 + size); // masses as the sizes
    return relative(default_time_step_fraction * 2 / std::sqrt(20 * stiffness / mass), 1e-12);
  };
  for (const double size : {1.0, 0.5}) {
    const double k_n = material.law.stiffness_at_overlap(1e-4 * radius);
    CHECK(Engine(pair_state(-1e-6, {1, size}), material).time_step() == step_at(k_n, size));
  }
  material.law = contact::RoughSphere(material.law.grain(), radius, 1e-7);
  CHECK(Engine(pair_state(1e-14), material).time_step() == step_at(material.law.first_stiffness(), 1));
}

TEST_CASE("the numbers of the grains do not matter, beyond round-off, for forces and memories") {
  for (const bool walls : {false, true}) {
    CAPTURE(walls);
    const Material material = test::quartz(radius, 0.3);
    Specimen state = test::fcc(radius, 3, 2e-7);
    const auto count = static_cast<std::uint32_t>(state.grain_count());
    if (walls)
      state.walls = test::walls(0.3);
    for (std::size_t g = 0; g < count; ++g)
      state.velocity[g] = 1e-3 * test::scatter(g);
    const auto after = [&](const Specimen& start, int steps) {
      Engine engine(start, material);
      for (int k = 0; k < steps; ++k)
        engine.step();
      return engine.state();
    };
    state = after(state, 20); // remembers contacts that carry tangential forces
    REQUIRE(state.history.size() > count);
    const auto renumbered = [&](std::uint32_t g) {
      return (g * 53 + 7) % count;
    }; // 53, 108: no common factor
    Specimen other = state;
    for (std::uint32_t g = 0; g < count; ++g) {
      other.position[renumbered(g)] = state.position[g];
      other.velocity[renumbered(g)] = state.velocity[g];
      other.angular_velocity[renumbered(g)] = state.angular_velocity[g];
    }
    for (ContactHistory& contact : other.history) {
      contact.i = renumbered(contact.i);
      contact.j = renumbered(contact.j);
      if (contact.i > contact.j) {
        std::swap(contact.i, contact.j);
        contact.tangential_force = -contact.tangential_force;
      }
    }
    if (walls)
      for (WallHistory& contact : other.walls->history)
        contact.grain = renumbered(contact.grain);
    const Specimen a = after(state, 50), b = after(other, 50);
    double velocity = 0, spin = 0, fastest = 0, fastest_spin = 0;
    for (std::uint32_t g = 0; g < count; ++g) {
      velocity = std::max(velocity, norm(a.velocity[g] - b.velocity[renumbered(g)]));
      spin = std::max(spin, norm(a.angular_velocity[g] - b.angular_velocity[renumbered(g)]));
      fastest = std::max(fastest, norm(a.velocity[g]));
      fastest_spin = std::max(fastest_spin, norm(a.angular_velocity[g]));
    }
    // Overlaps are 1e-4 of the coordinates, so round-off is 1e-12 of a force and grows in 50 steps of motion.
    CHECK(velocity < 1e-8 * fastest);
    CHECK(spin < 1e-8 * fastest_spin);
    CHECK(a.history.size() == b.history.size());
  }
}

TEST_CASE("own velocities are measured against the cell: a deforming cell does not drag its grains") {
  const Material material = test::quartz(radius, 0.5);
  Engine engine(test::fcc(radius, 3, 2e-7), material);
  engine.set_velocity_gradient(Mat3::diagonal(-1e-2, -1e-2, -1e-2));
  for (int k = 0; k < 100; ++k)
    engine.step();
  // A lattice deforms affinely: by symmetry no grain moves against the cell, beyond round-off.
  for (const Vec3& v : engine.state().velocity)
    CHECK(norm(v) < 1e-6 * 1e-2 * radius);
}

TEST_CASE("without friction no rotations and no histories are modelled") {
  const Material material = test::quartz(radius, 0);
  Specimen state = pair_state(1e-7);
  state.angular_velocity = {{1, 2, 3}, {4, 5, 6}};
  state.velocity[1] = {0, 1e-3, 0};
  Engine engine(state, material);
  for (int k = 0; k < 20; ++k)
    engine.step();
  CHECK(engine.state().history.empty());
  CHECK(engine.state().angular_velocity == std::vector<Vec3>(2));
}

TEST_CASE("impossible engines are refused") {
  const Specimen sound = pair_state(1e-7);
  const auto refused = [](const Specimen& state, const Material& material) {
    CHECK_THROWS_AS(Engine(state, material), InvalidArgument);
  };
  const Material material = test::quartz(radius, 0.5);
  Specimen none = sound;
  none.position.clear(), none.velocity.clear(), none.angular_velocity.clear();
  Specimen narrow = sound, foreign = sound, foreign_at_wall = sound, pulling_walls = sound;
  narrow.cell = Mat3::diagonal(3 * radius, 1, 1);
  foreign.history = {{0, 2, {0, 1e-4, 0}, 1e3}};
  foreign_at_wall.walls = Walls{.friction_coefficient = 0.3, .history = {{2, 0, {0, 1e-4, 0}, 1e3}}};
  pulling_walls.walls = test::walls(-0.1);
  for (const Specimen& state : {none, narrow, foreign, foreign_at_wall, pulling_walls})
    refused(state, material);
  Material weightless = material, undefined = material;
  weightless.density = 0;
  undefined.tangential_ratio = std::numeric_limits<double>::quiet_NaN();
  for (const Material& bad : {test::quartz(radius, -1), weightless, undefined})
    refused(sound, bad);
}
