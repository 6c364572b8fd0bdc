// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/contact/grains.hpp>
#include <granum/dem/engine.hpp>
#include <granum/dem/quasistatic.hpp>
#include <granum/dem/specimen.hpp>
#include <granum/packing/forces.hpp>

#include "lattice_state.hpp"
#include "unit.hpp"

using namespace granum::dem;

namespace {

using test::radius;
using test::shear_on;
constexpr double inf = std::numeric_limits<double>::infinity();

/// A lattice of grains between `least` and 1 in size, some of which touch, in motion.
Specimen lively(int edges, double least, bool walls) {
  Specimen state = test::fcc(radius, edges, 2e-7 + (1 - least) * radius);
  test::set_in_motion(state);
  for (std::size_t g = 0; g < state.grain_count(); ++g)
    state.size.push_back(0.5 * (1 + least + (1 - least) * std::sin(13 * static_cast<double>(g))));
  if (walls)
    state.walls = test::walls(0.3);
  return state;
}

/// Grains at random in a cube, grown until they fill it, then pressed together without friction.
Specimen packed(double pressure, const Material& material, double largest) {
  Specimen state = test::fcc(radius, 5, 0.0);
  for (std::size_t g = 0; g < state.grain_count(); ++g) {
    const double phase = static_cast<double>(g);
    state.size.push_back(g % 3 == 0 ? largest : 1.0);
    state.position[g] += 0.3 * radius * Vec3{std::sin(7 * phase), std::cos(3 * phase), std::sin(11 * phase)};
  }
  const double growth = std::cbrt(grain_volume(state) / (0.6 * determinant(state.cell)));
  state.cell = growth * state.cell;
  for (Vec3& x : state.position)
    x = growth * x;
  for (const double factor : {100.0, 1.0})
    (void)minimise_enthalpy(state, material.law, factor * pressure,
                            {.force_tolerance = 1e-10, .pressure_tolerance = 1e-10})
        .pressure();
  return state;
}

} // namespace

TEST_CASE("two grains without friction are pushed apart along their line, at the same energy and momentum") {
  const Material material = test::quartz(radius, 0);
  for (const std::vector<double>& size : {std::vector<double>{}, {0.5, 2}}) {
    Specimen state = test::pair_state(1e-7, size);
    state.velocity = {{0, 2e-5, 0}, {0, 0, 1e-5}};
    const auto momentum = [&](const Specimen& at) { // masses of the engine are as the radii
      return state.radius_of(0) * at.velocity[0] + state.radius_of(1) * at.velocity[1];
    };
    Engine engine(state, material);
    engine.set_damping(0);
    engine.set_time_step_fraction(0.01);
    const packing::Contact contact = contact_network(state, material).contacts.at(0);
    const double stored = contact.normal_force * contact.overlap / 2.5, before = engine.kinetic_energy();
    const double a = state.radius_of(0), b = state.radius_of(1);
    CHECK(contact.normal_force == // Hertz; the overlap is a difference of lengths
          relative(4.0 / 3 * 30e9 / 0.85 * std::sqrt(a * b / (a + b)) * std::pow(1e-7, 1.5), 1e-9));
    CHECK(engine.figures().mean_normal_force == relative(contact.normal_force, 1e-9));
    for (int k = 0; k < 3000; ++k)
      engine.step();
    CHECK(engine.figures().contacts == 0);
    CHECK(engine.kinetic_energy() == relative(before + stored, 1e-3));
    const Specimen after = engine.state();
    CHECK(after.velocity[1].x > 0);
    CHECK(norm(momentum(after) - momentum(state)) < 1e-9 * norm(momentum(state)));
  }
}

TEST_CASE("tangential force: k_t times the way of the surfaces, according to their spins and radii") {
  const Material material = test::quartz(radius, inf);
  const double overlap = 1e-7, w0 = 1e-3, w1 = 3e-3;
  for (const std::vector<double>& size : {std::vector<double>{}, {0.7, 1.8}}) {
    Specimen state = test::pair_state(overlap, size);
    state.angular_velocity = {{0, 0, w0}, {0, 0, w1}};
    Engine engine(state, material);
    engine.set_damping(0);
    const double dt = engine.time_step();
    engine.step();
    const packing::Contact contact = contact_network(engine.state(), material).contacts.at(0);
    const double a = state.radius_of(0), b = state.radius_of(1);
    const double share = 1 - overlap / (a + b); // of each radius that is left of it at the contact point
    const double expected = contact.tangential_stiffness * share * (a * w0 + b * w1) * dt;
    // j's surface at the contact moves along -y against i's, so i pulls it back along +y.
    CHECK(contact.tangential_force.y == relative(expected, 1e-9));
    CHECK(std::abs(contact.tangential_force.x) + std::abs(contact.tangential_force.z) < 1e-12 * expected);
  }
}

TEST_CASE("equal grains given one by one move as equal grains do") {
  const Material material = test::quartz(radius, 0.05);
  for (const bool walls : {false, true}) {
    Specimen equal = lively(3, 1, walls);
    equal.size.clear();
    Specimen listed = equal, scaled = equal;
    listed.size.assign(equal.grain_count(), 1.0);
    scaled.radius = 0.25 * radius;
    scaled.size.assign(equal.grain_count(), 4.0);
    Material of_quarter = material;
    of_quarter.law = contact::of_sizes(material.law, 0.25, 0.25);
    Engine one(equal, material), other(listed, material), third(scaled, of_quarter);
    for (Engine* engine : {&one, &other, &third}) {
      engine->set_damping(0); // the adaptive one follows the last digits
      shear_on(*engine, 30);
    }
    CHECK(one.figures().sliding > 0);
    const Specimen a = one.state(), b = other.state(), c = third.state();
    for (std::size_t g = 0; g < a.grain_count(); ++g) {
      CHECK(norm(a.position[g] - b.position[g]) < 1e-11 * radius);
      CHECK(norm(a.velocity[g] - b.velocity[g]) < 1e-8 * 1e-2);
      CHECK(norm(a.angular_velocity[g] - b.angular_velocity[g]) < 1e-8 * 2);
      CHECK(norm(a.position[g] - c.position[g]) < 1e-11 * radius);
    }
    CHECK(other.kinetic_energy() == relative(one.kinetic_energy(), 1e-9));
    CHECK(other.time_step() == relative(one.time_step(), 1e-12));
    CHECK(other.unbalanced_force_ratio() == relative(one.unbalanced_force_ratio(), 1e-8));
  }
}

TEST_CASE("sizes are written to the bit, a specimen of equal grains has the bytes that it had without them") {
  const auto bytes_of = [](const Specimen& state) {
    ByteWriter bytes;
    save_specimen(bytes, state);
    return std::string(bytes.bytes());
  };
  for (const bool walls : {false, true}) {
    Specimen state = lively(2, 0.5, walls);
    const std::string bytes = bytes_of(state);
    ByteReader reader(bytes, "bytes");
    CHECK(load_specimen(reader) == state);
    CHECK(reader.empty());
    Specimen equal = state;
    equal.size.clear();
    CHECK(bytes_of(equal).size() == bytes.size() - (state.grain_count() + 1) * sizeof(double));
  }
}

TEST_CASE("unequal grains are minimised to a force balance that the network confirms") {
  const Material material = test::quartz(radius, 0);
  const double pressure = 1e5;
  for (const double largest : {1.4, 3.0}) {
    CAPTURE(largest);
    const Specimen state = packed(pressure, material, largest);
    const packing::Assembly network = contact_network(state, material);
    CHECK(trace(contact_stress(network).tensor) / 3 == relative(pressure, 1e-9));
    CHECK(packing::unbalance(network).force_ratio < 1e-8);
    double cubes = 0;
    for (std::size_t g = 0; g < state.grain_count(); ++g)
      cubes += std::pow(state.radius_of(g), 3);
    CHECK(void_ratio(state) ==
          relative(determinant(state.cell) / (4.0 / 3 * std::numbers::pi * cubes) - 1, 1e-12));
    // The engine finds the same state in balance.
    Engine engine(state, material);
    engine.step();
    CHECK(engine.unbalanced_force_ratio() < 1e-6);
    CHECK(trace(engine.figures().stress) / 3 == relative(pressure, 1e-6));
  }
}

TEST_CASE("sizes that no grains can have are refused") {
  const Material material = test::quartz(radius, 0.5);
  const auto refused = [&](auto change) {
    Specimen state = test::pair_state(1e-7, {1, 2});
    change(state);
    CHECK_THROWS_AS((void)Engine(state, material), InvalidArgument);
    CHECK_THROWS_AS((void)minimise_energy(state, material.law), InvalidArgument);
  };
  refused([](Specimen& s) { s.size.pop_back(); });
  refused([](Specimen& s) { s.size[0] = 0; });
  refused([](Specimen& s) { s.size[1] = std::nan(""); });
  refused([](Specimen& s) { s.size[1] = 9; }); // wider than half of the cell
}
