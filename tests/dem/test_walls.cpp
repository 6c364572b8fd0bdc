// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/dem/specimen.hpp>

#include <granum/dem/engine.hpp>
#include <granum/dem/quasistatic.hpp>
#include <granum/packing/forces.hpp>

#include "lattice_state.hpp"
#include "unit.hpp"

using namespace granum::dem;

namespace {

using test::radius;

/// A box of walls that nothing touches unless a test places it so.
Specimen box(double x, double y, double z, double wall_friction) {
  Specimen state;
  state.radius = radius;
  state.cell = Mat3::diagonal(x, y, z);
  state.walls = test::walls(wall_friction);
  return state;
}

/// One grain between two walls across x, each at `overlap` from touching.
Specimen squeezed(double overlap, double wall_friction, double size = 1) {
  const double half = radius * size - overlap;
  Specimen state = box(2 * half, 8e-3, 8e-3, wall_friction);
  state.position = {{half, 4e-3, 4e-3}};
  if (size != 1)
    state.size = {size};
  return state;
}

/// Lattice of cubic cells, shaken, inside walls: enough grains for a box to press on.
Specimen shaken_box(double wall_friction) {
  Specimen state = test::fcc(radius, 3, -0.02 * radius);
  for (std::size_t g = 0; g < state.grain_count(); ++g)
    state.position[g] += 0.01 * radius * test::scatter(g);
  // The outermost centres of the lattice lie a quarter of an edge inside: room for R.
  state.cell = 1.2 * state.cell;
  for (Vec3& x : state.position)
    x += 0.1 / 1.2 * (state.cell * Vec3{1, 1, 1});
  state.walls = test::walls(wall_friction);
  return state;
}

/// What friction at the side walls adds to the contact stress: (1/V) sum of f_k x_k over the walls across the
/// other two axes.
Vec3 stress_by_wall_friction(const Specimen& state) {
  Vec3 sum;
  for (const WallHistory& contact : state.walls->history)
    for (int axis = 0; axis < 3; ++axis)
      sum[axis] += contact.tangential_force[axis] *
                   (0.5 * state.cell(axis, axis) - state.position[contact.grain][axis]) /
                   determinant(state.cell);
  return sum;
}

} // namespace

TEST_CASE("the walls of a sheared cell: unit normals into the cell, areas and distances of its faces") {
  Mat3 cell = Mat3::diagonal(2, 3, 4);
  cell(0, 1) = 0.5; // the second edge leans along x
  const auto planes = wall_planes(cell);
  const Vec3 middle = 0.5 * (cell * Vec3{1, 1, 1});
  for (std::size_t w = 0; w < wall_count; ++w) {
    CHECK(norm(planes[w].normal) == relative(1, 1e-15));
    CHECK(dot(middle - planes[w].centre, planes[w].normal) > 0);
  }
  // Volume = area times distance of opposite faces.
  for (std::size_t k = 0; k < 3; ++k)
    CHECK(planes[2 * k].area * dot(planes[2 * k + 1].centre - planes[2 * k].centre, planes[2 * k].normal) ==
          relative(24, 1e-14));
  CHECK(planes[0].area == relative(4 * std::hypot(3, 0.5), 1e-15));
  CHECK(planes[2].normal == Vec3{0, 1, 0});
}

TEST_CASE("one grain between two walls: the force of a rigid plane in closed form, and its stress") {
  const contact::GrainMaterial quartz{.shear_modulus = 30e9, .poisson_ratio = 0.15};
  const double overlap = 1e-7;
  const Material sphere = test::quartz(radius, 0);
  for (const double size : {1.0, 0.4, 2.5}) {
    CAPTURE(size);
    const Engine engine(squeezed(overlap, 0, size), sphere);
    // Hertz: a sphere against a rigid plane, (4/3) E/(1 - nu^2) sqrt(R) d^(3/2), E = 2 G (1 + nu).
    const double plane_strain = 2 * quartz.shear_modulus / (1 - quartz.poisson_ratio);
    const double force = 4.0 / 3 * plane_strain * std::sqrt(size * radius) * std::pow(overlap, 1.5);
    // An overlap is a difference of lengths 5e3 times as large, or more.
    CHECK(engine.wall_forces().force[0].x == relative(force, 1e-10));
    CHECK(engine.wall_forces().force[1].x == relative(-force, 1e-10));
    CHECK(engine.figures().wall_contacts == 2);
    CHECK(engine.figures().contacts == 0);
    CHECK(engine.figures().boundary_stress.x == relative(force / 64e-6, 1e-10));
    CHECK(engine.figures().stress(0, 0) == relative(force / 64e-6, 1e-10));
    CHECK(engine.figures().boundary_stress.y == 0);
    CHECK(contact_network(squeezed(overlap, 0, size), sphere).wall_contacts.at(0).normal_force ==
          relative(force, 1e-9));
  }

  // Any law: the plane stops the grain where another grain of its kind would stop it.
  Material cone = sphere;
  cone.law = contact::PowerLaw::cone(quartz, 0.4);
  CHECK(Engine(squeezed(overlap, 0), cone).wall_forces().force[0].x ==
        relative(cone.law.force(2 * overlap), 1e-11));
}

TEST_CASE("a rough wall carries tangential force to Coulomb's limit, a smooth one none") {
  const Material material = test::quartz(radius, 0.5);
  const double overlap = 1e-7;
  Specimen state = squeezed(overlap, std::numeric_limits<double>::infinity());
  state.velocity = {{0, 1e-4, 0}};
  const auto after_a_step = [&](double wall_friction) {
    state.walls->friction_coefficient = wall_friction;
    Engine engine(state, material);
    engine.set_damping(0);
    engine.step();
    return std::pair{engine.wall_forces(), engine.state()};
  };
  const double dt = Engine(state, material).time_step();
  // Sticking: k_t times the way of the surface, k_t = r k_n of the plane, on both walls against the motion.
  const auto [sticking, moved] = after_a_step(std::numeric_limits<double>::infinity());
  const double k_t = material.tangential_ratio * 2 * material.law.stiffness_at_overlap(2 * overlap);
  CHECK(sticking.force[0].y == relative(-k_t * 1e-4 * dt, 1e-9));
  CHECK(sticking.force[1].y == relative(-k_t * 1e-4 * dt, 1e-9));
  CHECK(moved.walls->history.size() == 2);
  CHECK(moved.walls->history[0].tangential_force.y == sticking.force[0].y);
  CHECK(sticking.sliding == 0);
  // Sliding: mu times the normal force.
  state.velocity = {{0, 1, 0}};
  const auto [sliding, slid] = after_a_step(0.3);
  CHECK(sliding.force[0].y == relative(-0.3 * sliding.force[0].x, 1e-12));
  CHECK(sliding.sliding == 2);
  const auto [smooth, unhindered] = after_a_step(0);
  CHECK(smooth.force[0].y == 0);
  CHECK(unhindered.velocity[0].y == 1);
  CHECK(unhindered.walls->history.empty());
}

TEST_CASE("a wall turns with its face: a grain that rolls along with a rotating box feels no slip") {
  // Rigid rotation of the whole box about z at the rate w, with or without the grain's spin.
  const Material material = test::quartz(radius, 0.5);
  const double w = 10;
  Mat3 spin;
  spin(0, 1) = -w;
  spin(1, 0) = w;
  double dt = 0;
  const auto on_grain = [&](double own_spin) {
    Specimen state = squeezed(1e-7, 1e100);
    state.angular_velocity = {{0, 0, own_spin}};
    Engine engine(state, material);
    engine.set_damping(0);
    engine.set_velocity_gradient(spin);
    engine.step();
    dt = engine.time_step();
    return engine.wall_forces().force[0];
  };
  const Vec3 rolling = on_grain(w);
  // The normal has turned by w dt, which tilts the normal force by as much.
  CHECK(std::hypot(rolling.y, rolling.z) <= 1.01 * w * dt * norm(rolling));
  // Without the grain's spin the surfaces slip: R w dt k_t.
  const double k_t = material.tangential_ratio * 2 * material.law.stiffness_at_overlap(2e-7);
  CHECK(norm(on_grain(0) - rolling) == relative(k_t * radius * w * dt, 0.01));
}

TEST_CASE(
    "at rest the contact stress, wall branches included, is the wall stress plus what wall friction bears") {
  for (const double wall_friction : {0.0, 0.3}) {
    CAPTURE(wall_friction);
    const Material material = test::quartz(radius, 0.5);
    Specimen state = shaken_box(wall_friction);
    REQUIRE(minimise_enthalpy(state, material.law, 1e6).converged);
    REQUIRE(minimise_enthalpy(state, material.law, 100e3).converged);
    Engine engine(state, material);
    const Vec3 target{100e3, 110e3, 120e3};
    REQUIRE(equilibrate(engine, target, {.force_tolerance = 1e-7}).converged());
    const StepFigures& figures = engine.figures();
    const Vec3 by_friction = stress_by_wall_friction(engine.state());
    const packing::Assembly frozen = contact_network(engine.state(), material);
    const packing::ContactStress by_contacts = contact_stress(frozen);
    CHECK(
        (figures.contacts == frozen.contacts.size() && figures.wall_contacts == frozen.wall_contacts.size()));
    double forces = 0;
    for (const auto* const all : {&frozen.contacts, &frozen.wall_contacts})
      for (const packing::Contact& c : *all)
        forces += c.normal_force;
    CHECK(figures.mean_normal_force ==
          relative(forces / static_cast<double>(figures.contacts + figures.wall_contacts), 1e-9));
    for (int axis = 0; axis < 3; ++axis) {
      CHECK(figures.boundary_stress[axis] == relative(target[axis], 2e-6));
      // Exact at equilibrium; the residual forces are 1e-7 of the mean one.
      CHECK(figures.stress(axis, axis) == relative(figures.boundary_stress[axis] + by_friction[axis], 1e-5));
      CHECK((by_friction[axis] == 0) == (wall_friction == 0));
      CHECK(by_contacts.tensor(axis, axis) == relative(figures.stress(axis, axis), 1e-11));
    }
    // The frozen contacts are the engine's, those of the walls with them.
    CHECK(frozen.wall_contacts.size() == figures.wall_contacts);
    CHECK(unbalance(frozen).force_ratio < 1e-6);
    CHECK(unbalance(frozen).moment_ratio < 1e-6);
    for (const packing::Contact& c : frozen.wall_contacts) {
      CHECK(c.overlap == relative(radius - norm(c.branch), 1e-9));
      CHECK((c.tangential_stiffness == 0) == (wall_friction == 0));
      CHECK(norm(c.tangential_force) <= wall_friction * c.normal_force * (1 + 1e-12));
      CHECK((norm(c.tangential_force) > 0.99 * wall_friction * c.normal_force || !c.sliding));
    }
    // Tangential forces stand across the branches: the work of the cell knows nothing of them.
    CHECK(pressure_by_cell_work(frozen, material.law, radius) == relative(by_contacts.mean(), 1e-7));
    // Opposite walls balance, and the frictionless state of the minimiser stood at its pressure too.
    Vec3 sum;
    double size = 0;
    const WallForces on_walls = engine.wall_forces();
    for (const Vec3& of_wall : on_walls.force)
      sum += of_wall, size += norm(of_wall);
    CHECK(norm(sum) < 1e-5 * size);
    CHECK(Engine(state, material).figures().boundary_stress.x == relative(100e3, 1e-3));
  }
}
