// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/dem/engine.hpp>

#include "lattice_state.hpp"
#include "unit.hpp"

using namespace granum::dem;

namespace {

using test::radius;

/// Two spheres that touch with the given overlap along x.
Specimen pair_state(double overlap) {
  Specimen state;
  state.radius = radius;
  state.cell = Mat3::diagonal(8e-3, 8e-3, 8e-3);
  state.position = {{4e-3, 4e-3, 4e-3}, {4e-3 + 2 * radius - overlap, 4e-3, 4e-3}};
  state.velocity.resize(2);
  state.angular_velocity.resize(2);
  return state;
}

double elastic_energy(const Specimen& state, const Material& material) {
  double sum = 0;
  for (const packing::Contact& c : contact_network(state, material).contacts)
    sum += material.law.energy(c.overlap);
  return sum;
}

} // namespace

TEST_CASE("a frictionless contact pushes its grains apart along their line, and conserves momentum") {
  const Material material = test::quartz(radius, 0);
  Specimen state = pair_state(1e-7);
  state.velocity = {{0, 0.002, 0}, {0, 0, 0.001}};
  Engine engine(state, material);
  engine.set_damping(0);
  for (int k = 0; k < 400; ++k)
    engine.step();
  // Energy is not asked for: 0.8 of the stability limit takes one stiff contact apart in two steps.
  CHECK(elastic_energy(engine.state(), material) == 0);
  const Specimen after = engine.state();
  CHECK(after.velocity[1].x > 0);
  const Vec3 momentum = after.velocity[0] + after.velocity[1];
  CHECK(norm(momentum - Vec3{0, 0.002, 0.001}) < 1e-14);
}

TEST_CASE(
    "tangential force: k_t times the relative displacement of the surfaces, equal and opposite torques") {
  const Material material = test::quartz(radius, std::numeric_limits<double>::infinity());
  const double overlap = 1e-7;
  Specimen state = pair_state(overlap);
  // Pure spin of both grains about z: surfaces move against each other by (w1 + w2) l/2 along y.
  const double spin = 1e-3;
  state.angular_velocity = {{0, 0, spin}, {0, 0, 2 * spin}};
  Engine engine(state, material);
  engine.set_damping(0);
  const double dt = engine.time_step();
  engine.step();
  const packing::Contact contact = contact_network(engine.state(), material).contacts.at(0);
  const double length = 2 * radius - overlap;
  const double expected = contact.tangential_stiffness * 3 * spin * length / 2 * dt;
  // j's surface at the contact moves along -y against i's, so i pulls it back along +y.
  CHECK(contact.tangential_force.y == relative(expected, 1e-9));
  CHECK(std::abs(contact.tangential_force.x) + std::abs(contact.tangential_force.z) < 1e-12 * expected);
}

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
    state.velocity[g] =
        1e-6 * Vec3{std::sin(7.0 * static_cast<double>(g)), std::cos(3.0 * static_cast<double>(g)),
                    std::sin(11.0 * static_cast<double>(g) + 1)};
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

TEST_CASE(
    "the same start gives the same bits, and a state taken out and put back goes on with the same forces") {
  const Material material = test::quartz(radius, 0.5);
  Specimen state = test::fcc(radius, 3, 2e-7);
  for (std::size_t g = 0; g < state.grain_count(); ++g)
    state.velocity[g] = {1e-4 * std::sin(5.0 * static_cast<double>(g)), 0,
                         1e-4 * std::cos(2.0 * static_cast<double>(g))};
  const auto run = [&](Specimen start, int steps) {
    Engine engine(std::move(start), material);
    for (int k = 0; k < steps; ++k)
      engine.step();
    return engine.state();
  };
  const Specimen once = run(state, 300);
  CHECK(once == run(state, 300));
  const packing::Assembly before = contact_network(once, material);
  Engine again(once, material);
  const packing::Assembly after = contact_network(again.state(), material);
  REQUIRE(before.contacts.size() == after.contacts.size());
  for (std::size_t k = 0; k < before.contacts.size(); ++k)
    CHECK(norm(force(before.contacts[k]) - force(after.contacts[k])) <=
          1e-9 * norm(force(before.contacts[k])));
}

TEST_CASE("the numbers of the grains do not matter, beyond round-off, for forces and memories") {
  for (const bool walls : {false, true}) {
    CAPTURE(walls);
    const Material material = test::quartz(radius, 0.3);
    Specimen state = test::fcc(radius, 3, 2e-7);
    const std::size_t count = state.grain_count();
    if (walls)
      state.walls = Walls{.friction_coefficient = 0.3, .history = {}};
    for (std::size_t g = 0; g < count; ++g) {
      const double phase = static_cast<double>(g);
      state.velocity[g] = 1e-3 * Vec3{std::sin(5 * phase), std::cos(3 * phase), std::sin(2 * phase + 1)};
    }
    Engine first(state, material);
    for (int k = 0; k < 20; ++k)
      first.step();
    state = first.state(); // remembers contacts that carry tangential forces
    REQUIRE(state.history.size() > count);
    const auto renumbered = [&](std::size_t g) {
      return (g * 53 + 7) % count;
    }; // 53 and 108: no common factor
    Specimen other = state;
    for (std::size_t g = 0; g < count; ++g) {
      other.position[renumbered(g)] = state.position[g];
      other.velocity[renumbered(g)] = state.velocity[g];
      other.angular_velocity[renumbered(g)] = state.angular_velocity[g];
    }
    for (ContactHistory& contact : other.history) {
      contact.i = static_cast<std::uint32_t>(renumbered(contact.i));
      contact.j = static_cast<std::uint32_t>(renumbered(contact.j));
      if (contact.i > contact.j) {
        std::swap(contact.i, contact.j);
        contact.tangential_force = -contact.tangential_force;
      }
    }
    if (walls)
      for (WallHistory& contact : other.walls->history)
        contact.grain = static_cast<std::uint32_t>(renumbered(contact.grain));
    Engine one(state, material), two(other, material);
    for (int k = 0; k < 50; ++k) {
      one.step();
      two.step();
    }
    const Specimen a = one.state(), b = two.state();
    double velocity = 0, spin = 0, fastest = 0, fastest_spin = 0;
    for (std::size_t g = 0; g < count; ++g) {
      velocity = std::max(velocity, norm(a.velocity[g] - b.velocity[renumbered(g)]));
      spin = std::max(spin, norm(a.angular_velocity[g] - b.angular_velocity[renumbered(g)]));
      fastest = std::max(fastest, norm(a.velocity[g]));
      fastest_spin = std::max(fastest_spin, norm(a.angular_velocity[g]));
    }
    // Overlaps are 1e-4 of the coordinates, so round-off is 1e-12 of a force and grows in 50 steps of motion.
    CHECK(velocity < 1e-8 * fastest);
    CHECK(spin < 1e-8 * fastest_spin);
    CHECK(a.history.size() == b.history.size());
    CHECK(two.figures().contacts == one.figures().contacts);
    CHECK(trace(two.figures().stress) == relative(trace(one.figures().stress), 1e-9));
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
  Specimen empty;
  empty.radius = radius;
  empty.cell = Mat3::identity();
  CHECK_THROWS_AS(Engine(empty, test::quartz(radius, 0.5)), InvalidArgument);
  Specimen narrow = pair_state(1e-7);
  narrow.cell = Mat3::diagonal(3 * radius, 1, 1);
  CHECK_THROWS_AS(Engine(narrow, test::quartz(radius, 0.5)), InvalidArgument);
  CHECK_THROWS_AS(Engine(pair_state(1e-7), test::quartz(radius, -1)), InvalidArgument);
  Specimen foreign = pair_state(1e-7);
  foreign.history = {{0, 2, {0, 1e-4, 0}, 1e3}};
  CHECK_THROWS_AS(Engine(foreign, test::quartz(radius, 0.5)), InvalidArgument);
  foreign.history.clear();
  foreign.walls = Walls{.friction_coefficient = 0.3, .history = {{2, 0, {0, 1e-4, 0}, 1e3}}};
  CHECK_THROWS_AS(Engine(foreign, test::quartz(radius, 0.5)), InvalidArgument);
}
