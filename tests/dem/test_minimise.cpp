// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/dem/quasistatic.hpp>

#include <random>

#include "lattice_state.hpp"
#include "stop_at.hpp"
#include "unit.hpp"

using namespace granum::dem;

namespace {

/// Elastic energy of all contacts of a state that is stretched by (1 + strain) along one axis.
double energy(Specimen state, const Material& material, int axis, double strain) {
  Mat3 stretch = Mat3::identity();
  stretch(axis, axis) += strain;
  state.cell = stretch * state.cell;
  for (Vec3& x : state.position)
    x = stretch * x;
  double sum = 0;
  for (const packing::Contact& c : contact_network(state, material).contacts)
    sum += material.law.energy(c.overlap);
  return sum;
}

Specimen disordered(double radius) {
  Specimen state = test::fcc(radius, 3, 0.03 * radius);
  std::mt19937_64 random(11);
  for (Vec3& x : state.position)
    for (int axis = 0; axis < 3; ++axis)
      x[axis] += 0.02 * radius * (static_cast<double>(random() >> 11) * 0x1p-52 - 1);
  return state;
}

} // namespace

TEST_CASE("two overlapping spheres move apart along their line until no overlap is left") {
  Specimen state;
  state.radius = 1e-3;
  state.cell = Mat3::diagonal(10e-3, 10e-3, 10e-3);
  state.position = {{5e-3, 5e-3, 5e-3}, {6e-3, 5.5e-3, 5e-3}};
  const Vec3 direction = state.position[1] - state.position[0];
  const RelaxReport report = minimise_energy(state, test::quartz_sphere(1e-3));
  CHECK(report.converged);
  const Vec3 branch = state.position[1] - state.position[0];
  // They may coast on after the last touch, by no more than the 0.02 R of one step for each step that it
  // takes to stop.
  CHECK(norm(branch) >= 2e-3 * (1 - 1e-7));
  CHECK(norm(branch) < 2.1e-3);
  CHECK(norm(cross(branch, direction)) < 1e-12 * norm(branch) * norm(direction));
}

TEST_CASE("a prescribed pressure is reached, and equals the work of the cell on every axis") {
  const double radius = 0.5e-3;
  Specimen state = disordered(radius);
  state.history = {{0, 1, {1, 0, 0}, 1}};
  state.angular_velocity.assign(state.grain_count(), Vec3{1, 2, 3});
  const Material material = test::quartz(radius, 0);
  for (const double pressure : {1e8, 1e5}) {
    const RelaxReport report = minimise_enthalpy(state, material.law, pressure);
    REQUIRE(report.converged);
    CHECK(report.pressure() == relative(pressure, 2e-9));
    CHECK(report.unbalanced_force_ratio < 1e-9);
    double mean = 0;
    for (int axis = 0; axis < 3; ++axis) {
      // Central difference of the energy; its error is of the order (step/overlap strain)^2.
      const double step = 1e-3 * material.law.overlap(pressure * radius * radius) / radius;
      const double work = energy(state, material, axis, -step) - energy(state, material, axis, step);
      mean += work / (2 * step * determinant(state.cell)) / 3;
    }
    CHECK(mean == relative(pressure, 1e-6));
  }
  CHECK(state.history.empty());
  CHECK(state.angular_velocity == std::vector<Vec3>(state.grain_count()));
}

TEST_CASE("a minimiser out of steps or stopped is in the state of its last step, and has no pressure") {
  const auto relaxed = [](const MinimiseOptions& options, bool enthalpy) {
    Specimen state = disordered(1e-3);
    const contact::PowerLaw law = test::quartz_sphere(1e-3);
    const RelaxReport report =
        enthalpy ? minimise_enthalpy(state, law, 1e7, options) : minimise_energy(state, law, options);
    return std::pair{state, report};
  };
  for (const bool enthalpy : {false, true})
    for (const std::size_t question : {1u, 7u, 30u}) {
      CAPTURE(question);
      const auto [stopped, report] = relaxed({.stop_requested = test::StopAt(question)}, enthalpy);
      const auto [limited, other] = relaxed({.max_steps = question - 1}, enthalpy);
      CHECK(report.stopped);
      CHECK_FALSE(other.stopped);
      CHECK_FALSE(report.converged);
      CHECK_THROWS_AS((void)other.pressure(), NotConverged);
      CHECK(report.steps == question - 1);
      CHECK(stopped == limited);
      CHECK(report.unbalanced_force_ratio == other.unbalanced_force_ratio);
      // The ratio is that of the state where it ended, which one that begins there sees first.
      Specimen state = limited;
      const RelaxReport seen = minimise_energy(state, test::quartz_sphere(1e-3), {.max_steps = 0});
      if (!enthalpy)
        CHECK(report.unbalanced_force_ratio == doctest::Approx(seen.unbalanced_force_ratio).epsilon(1e-9));
    }
}

TEST_CASE("impossible minimisations are refused") {
  Specimen state = disordered(1e-3);
  const contact::PowerLaw law = test::quartz_sphere(1e-3);
  CHECK_THROWS_AS((void)minimise_enthalpy(state, law, 0), InvalidArgument);
  CHECK_THROWS_AS((void)minimise_enthalpy(state, law, std::numeric_limits<double>::quiet_NaN()),
                  InvalidArgument);
  Specimen empty;
  empty.radius = 1e-3;
  CHECK_THROWS_AS((void)minimise_energy(empty, law), InvalidArgument);
}
