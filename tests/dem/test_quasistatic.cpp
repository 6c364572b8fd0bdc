// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/dem/quasistatic.hpp>

#include "lattice_state.hpp"
#include "stop_at.hpp"
#include "unit.hpp"

using namespace granum::dem;

namespace {
using test::radius;
}

TEST_CASE(
    "the servo brings a lattice to an isotropic pressure, where its overlaps are those of the closed form") {
  const Material material = test::quartz(radius, 0.5);
  Engine engine(test::fcc(radius, 3, 1e-8), material);
  const double pressure = 50e3;
  const QuasistaticReport report = equilibrate(engine, {pressure, pressure, pressure});
  REQUIRE(report.converged());
  for (int axis = 0; axis < 3; ++axis)
    CHECK(report.stress()(axis, axis) == relative(pressure, 1e-6));
  CHECK(report.unbalanced_force_ratio < 1e-6);
  CHECK(report.steps % 10 == 0);
  CHECK(report.largest_inertial_number <= 5e-4 * (1 + 1e-12));
  const double overlap = material.law.overlap(std::numbers::sqrt2 * radius * radius * pressure);
  const packing::Assembly assembly = contact_network(engine.state(), material);
  // R in p = f/(sqrt 2 R^2) is half of the branch: 2 overlap/R apart from the radius.
  CHECK(assembly.contacts.front().overlap == relative(overlap, 1e-3));
}

TEST_CASE("a step of the servo closes a 27th of each gap, but for the largest rate") {
  const Material material = test::quartz(radius, 0.5);
  for (const double off : {1e-6, 0.5}) {
    Engine engine(test::fcc(radius, 3, 2e-7), material);
    const StepFigures figures = engine.figures();
    const Mat3 before = engine.cell();
    Vec3 target = figures.boundary_stress;
    target.x *= 1 + off, target.z *= 1 - 2 * off / 3;
    const double pressure = (target.x + target.y + target.z) / 3, dt = engine.time_step(),
                 time = engine.diameter() * std::sqrt(material.density / pressure);
    const QuasistaticOptions options{.inertial_number = 1e-4, .max_steps = 1};
    const QuasistaticReport report = equilibrate(engine, target, options);
    double squares = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double rate = std::clamp((target[axis] - figures.boundary_stress[axis]) /
                                         (27 * dt * std::max(figures.p_wave_modulus, pressure)),
                                     -1e-4 / time, 1e-4 / time);
      squares += rate * rate;
      CHECK(std::abs((1 - engine.cell()(axis, axis) / before(axis, axis)) / dt - rate) < 1e-6 * 1e-4 / time);
    }
    CHECK(report.largest_inertial_number == relative(std::sqrt(squares / 3) * time, 1e-9));
    CHECK((off > 0.1) == (std::sqrt(squares / 2) * time > 0.99e-4));
  }
}

TEST_CASE("small strains of a lattice give the closed-form moduli") {
  const Material material = test::quartz(radius, std::numeric_limits<double>::infinity());
  const double overlap = 2e-7;
  const Specimen state = test::fcc(radius, 3, overlap);
  const double k_n = material.law.stiffness_at_overlap(overlap);
  const double k_t = material.tangential_ratio * k_n;
  const double half_branch = radius - overlap / 2;
  const double strain = 1e-9;
  // Half of the stress swing between +strain and -strain over the strain.
  const auto modulus = [&](Mat3 direction, int row, int column) {
    double swing = 0;
    for (const double sign : {1.0, -1.0}) {
      Engine engine(state, material);
      swing -=
          sign *
          deform(engine, (sign * strain) * direction, 50, {.force_tolerance = 1e-9}).stress()(row, column);
    }
    return swing / (2 * strain);
  };
  Mat3 axial, shear;
  axial(0, 0) = 1;
  shear(0, 2) = 1;
  const double c11 = (k_n + k_t) / (std::numbers::sqrt2 * half_branch);
  // Terms of order stress / modulus, about overlap/R = 4e-4, stand between Cauchy stress rates and the
  // stiffness.
  CHECK(modulus(axial, 0, 0) == relative(c11, 1e-3));
  CHECK(modulus(axial, 1, 1) == relative((k_n - k_t) / (2 * std::numbers::sqrt2 * half_branch), 1e-2));
  CHECK(modulus(shear, 0, 2) == relative(c11 / 2, 1e-3));
}

TEST_CASE(
    "a fraction of the time step stays when the step is chosen anew, and impossible options are refused") {
  const Vec3 target{1e5, 1e5, 1e5};
  const auto time_step = [&](double fraction) {
    Engine engine(test::fcc(radius, 3, 1e-8), test::quartz(radius, 0.5));
    CHECK(equilibrate(engine, target, {.time_step_fraction = fraction}).stress()(0, 0) ==
          relative(target.x, 1e-6));
    return engine.time_step();
  };
  const double usual = time_step(default_time_step_fraction);
  CHECK(time_step(default_time_step_fraction / 4) == relative(usual / 4, 1e-5));

  Engine engine(test::fcc(radius, 3, 1e-8), test::quartz(radius, 0.5));
  CHECK_THROWS_AS((void)equilibrate(engine, {1e5, -1, 1e5}), InvalidArgument);
  CHECK_THROWS_AS((void)equilibrate(engine, target, {.inertial_number = 0}), InvalidArgument);
  for (const double bad : {0.0, 1.0001, std::nan("")}) {
    CHECK_THROWS_AS(engine.set_time_step_fraction(bad), InvalidArgument);
    CHECK_THROWS_AS((void)equilibrate(engine, target, {.time_step_fraction = bad}), InvalidArgument);
    CHECK_THROWS_AS((void)deform(engine, Mat3{}, 0, {.time_step_fraction = bad}), InvalidArgument);
  }
}

TEST_CASE(
    "a shear at held stress: the closed-form shear stress, and the normal stresses that were asked for") {
  const Material material = test::quartz(radius, std::numeric_limits<double>::infinity());
  Engine engine(test::fcc(radius, 3, 2e-7), material);
  const double start = trace(engine.figures().stress) / 3;
  // Normal stresses are to move on the way: unequally, and by more than the shear stress.
  const Vec3 target{1.0002 * start, 1.0004 * start, 0.9999 * start};
  Mat3 shear;
  shear(0, 2) = 1e-8;
  const QuasistaticOptions options{.force_tolerance = 1e-8, .stress_tolerance = 1e-8};
  const QuasistaticReport report = shear_at_stress(engine, shear, 50, target, options);
  REQUIRE(report.converged());
  for (int axis = 0; axis < 3; ++axis)
    CHECK(report.stress()(axis, axis) == relative(target[axis], 2e-8));
  const double k_n = material.law.stiffness_at_overlap(2e-7);
  const double c44 = (1 + material.tangential_ratio) * k_n / (2 * std::numbers::sqrt2 * (radius - 1e-7));
  // Terms of order overlap/R, and stiffnesses that change with the normal stress.
  CHECK(-report.stress()(0, 2) == relative(c44 * shear(0, 2), 1e-3));
  CHECK(engine.cell()(0, 2) == relative(shear(0, 2) * engine.cell()(2, 2), 1e-3));
  CHECK_THROWS_AS((void)shear_at_stress(engine, shear, 50, {1e5, 0, 1e5}), InvalidArgument);
}

TEST_CASE("a stop request is observed before the next step of any kind") {
  const Material material = test::quartz(radius, 0.5);
  Mat3 shear;
  shear(0, 2) = 1e-6;
  for (const std::size_t question : {1u, 37u, 60u}) {
    CAPTURE(question);
    Engine servo(test::fcc(radius, 3, 1e-8), material), sheared(test::fcc(radius, 3, 2e-7), material);
    const QuasistaticReport first =
        equilibrate(servo, {1e5, 1e5, 1e5}, {.stop_requested = test::StopAt(question)});
    CHECK(first.outcome == Outcome::stopped);
    CHECK_THROWS_AS((void)first.stress(), NotConverged);
    CHECK(first.steps == question - 1);
    // 40 steps of ramp: some stop on it, some while the sheared cell comes to rest.
    const QuasistaticReport second =
        deform(sheared, shear, 40, {.force_tolerance = 1e-14, .stop_requested = test::StopAt(question)});
    CHECK(second.outcome == Outcome::stopped);
    CHECK(second.steps == question - 1);
    CHECK(sheared.steps() == question - 1);
  }
  // The rate of a ramp over the inertial rate of the stress before it.
  Engine ramped(test::fcc(radius, 3, 2e-7), material);
  const double pressure = trace(ramped.figures().stress) / 3;
  const QuasistaticReport report = deform(ramped, shear, 40, {.max_steps = 40});
  CHECK(
      report.largest_inertial_number ==
      relative(1e-6 / (40 * ramped.time_step()) * 2 * radius * std::sqrt(material.density / pressure), 1e-3));
  // A stop on a ramp that would have taken all steps there are.
  Engine engine(test::fcc(radius, 3, 2e-7), material);
  CHECK(deform(engine, shear, 40, {.max_steps = 10, .stop_requested = test::StopAt(20)}).outcome ==
        Outcome::stopped);
}

TEST_CASE("a run at fixed cell may end when its stress is constant, in less time and with the same stress") {
  const Material material = test::quartz(radius, std::numeric_limits<double>::infinity());
  const Specimen state = test::fcc(radius, 3, 2e-7);
  Mat3 shear;
  shear(0, 2) = 1e-8;
  const auto sheared = [&](double settled_stress) {
    Engine engine(state, material);
    // Nothing comes to rest to the bit within these steps.
    return deform(engine, shear, 50,
                  {.force_tolerance = 1e-300,
                   .max_steps = 20000,
                   .settled_stress = settled_stress,
                   .settle_steps = 100});
  };
  const QuasistaticReport to_the_end = sheared(0);
  CHECK(to_the_end.outcome == Outcome::step_limit);
  CHECK_THROWS_AS((void)to_the_end.stress(), NotConverged);
  const double stress = to_the_end.last_stress(0, 2);
  const QuasistaticReport early = sheared(1e-6 * std::abs(stress));
  CHECK(early.outcome == Outcome::settled);
  CHECK(early.steps < 2000);
  CHECK(early.stress()(0, 2) == relative(stress, 1e-6));
  // Three spells at least, however much may change.
  CHECK(sheared(1e300).steps == 50 + 3 * 100);
  CHECK_THROWS_AS((void)sheared(-1), InvalidArgument);
}
