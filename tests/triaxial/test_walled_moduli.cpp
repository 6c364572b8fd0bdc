// SPDX-License-Identifier: GPL-3.0-or-later
// Moduli of specimens between walls by two independent routes: linear algebra and moving the walls.
#include <Eigen/LU>
#include <granum/network/linear_response.hpp>
#include <granum/triaxial/probe.hpp>
#include <granum/triaxial/shear_test.hpp>
#include <granum/triaxial/specimen.hpp>

#include "dem/lattice_state.hpp"
#include "measured_specimen.hpp"
#include "unit.hpp"

using namespace granum::triaxial;
using elastic::Matrix6;

namespace {

using test::material;
using test::pressure;
using test::radius;

/// Loose specimens take long to come to rest: fewer grains.
SpecimenRecipe recipe(Density density) {
  SpecimenRecipe recipe{.material = material, .radius = radius};
  recipe.grains = density == Density::dense ? 300 : 150;
  recipe.seed = 4;
  recipe.wall_friction = 0;
  return recipe;
}

dem::Specimen made(Density density) {
  return freeze_in_place(test::compressed(recipe(density), density, {pressure}), material).state();
}

/// Specimens between smooth walls, frozen, each made once and when it is asked for.
const dem::Specimen& specimen(Density density) {
  if (density == Density::dense) {
    static const dem::Specimen dense = made(Density::dense);
    return dense;
  }
  static const dem::Specimen loose = made(Density::loose);
  return loose;
}

/// At rest without friction, and without the grains that bear next to nothing: those that just touch others
/// have no place from which they could answer linearly.
dem::Specimen firmly_held(dem::Specimen state) {
  while (true) {
    state = freeze_in_place(state, material, 1e-10).state();
    const packing::Assembly assembly = dem::contact_network(state, material);
    std::vector<double> largest(state.grain_count());
    for (const packing::Contact& c : assembly.contacts)
      for (const std::size_t grain : {c.i, c.j})
        largest[grain] = std::max(largest[grain], c.normal_force);
    for (const packing::Contact& c : assembly.wall_contacts)
      largest[c.i] = std::max(largest[c.i], c.normal_force);
    dem::Specimen held = state;
    held.position.clear();
    held.velocity.clear();
    held.angular_velocity.clear();
    held.history.clear();
    held.walls->history.clear();
    for (std::size_t g = 0; g < state.grain_count(); ++g)
      if (largest[g] > 0.1 * pressure * radius * radius)
        held.position.push_back(state.position[g]);
    if (held.grain_count() == state.grain_count())
      return state;
    state = held;
  }
}

/// Stress swing of moving the walls by a strain to and fro, over the strain, with every contact sticking.
Mat3 swing(const dem::Specimen& state, const Mat3& direction, double strain) {
  dem::Material sticking = material;
  sticking.friction_coefficient = std::numeric_limits<double>::infinity();
  Mat3 sum;
  for (const double sign : {1.0, -1.0}) {
    dem::Engine engine(state, sticking);
    const auto report = dem::deform(engine, (sign * strain) * direction, 100,
                                    {.force_tolerance = 1e-10, .max_steps = 100000});
    sum += (-sign / (2 * strain)) * report.stress();
  }
  return sum;
}

/// Shear modulus of a specimen whose three normal stresses are held: their changes are zero in the inverse.
double held_modulus(const Matrix6& c, int k) {
  Eigen::Matrix4d part;
  const std::array<int, 4> of{0, 1, 2, k};
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column)
      part(row, column) = c(of[static_cast<std::size_t>(row)], of[static_cast<std::size_t>(column)]);
  return 1 / part.inverse()(3, 3);
}

/// Work that a closed loop leaves in the specimen, per volume, from its first end on.
double dissipation(const ProbeResult& result, std::size_t loop_points) {
  double sum = 0;
  for (std::size_t k = loop_points; k + 1 < result.loop().size(); ++k)
    sum += (result.loop()[k].shear_stress + result.loop()[k + 1].shear_stress) / 2 *
           (result.loop()[k + 1].shear_strain - result.loop()[k].shear_strain);
  return sum;
}

} // namespace

TEST_CASE("between walls: network and moved walls agree on normal and shear moduli") {
  for (const Density density : {Density::dense, Density::loose}) {
    CAPTURE(density == Density::dense);
    const dem::Specimen& state = specimen(density);
    const Matrix6 c = test::frozen_network(state, material).response.relaxed().matrix;
    for (const ShearMode mode : {ShearMode::hh, ShearMode::hv, ShearMode::vh}) {
      const ProbeResult result = probe(state, material, mode);
      const int k = mode == ShearMode::hh ? 5 : 4;
      CHECK(result.converged);
      CHECK(result.shear_modulus() == relative(c(k, k), 0.01));
    }
    for (int axis = 0; axis < 3; ++axis) {
      Mat3 strain;
      strain(axis, axis) = 1;
      const Mat3 stress = swing(state, strain, 1e-8);
      for (int other = 0; other < 3; ++other)
        CHECK(std::abs(stress(other, other) - c(axis, other)) < 0.01 * c(axis, axis));
    }
  }
}

TEST_CASE("between walls without tangential forces: the same but for the prestress, which is known") {
  // Compressed without friction, no contact carries a tangential force that the engine would scale down with
  // its stiffness: what the walls measure is the change of Cauchy stress of a stressed elastic body,
  // -ds = C e + s tr(e) - s e, with the C of the network under its prestress.
  SpecimenRecipe at_pressure = recipe(Density::dense);
  at_pressure.first_pressure = pressure;
  const dem::Specimen state = firmly_held(frictionless_specimen(at_pressure).state);
  const packing::Assembly assembly = dem::contact_network(state, material);
  const Matrix6 c = network::linear_response(assembly, {.prestress = true}).relaxed().matrix;
  const ProbeOptions fine{
      .amplitude = 1e-8, .force_tolerance = 1e-10, .settled_share = 0, .max_steps = 100000};
  for (const ShearMode mode : {ShearMode::hh, ShearMode::hv, ShearMode::vh}) {
    const ProbeResult result = probe(state, material, mode, fine);
    const int k = mode == ShearMode::hh ? 5 : 4;
    CHECK(result.shear_modulus() == relative(c(k, k) - pressure / 2, 2e-4));
    // The error that the options name for the default; a tenth of that share leaves far less.
    const ProbeResult settled = probe(state, material, mode, {.amplitude = 1e-8, .force_tolerance = 1e-300});
    CHECK(settled.converged);
    CHECK(settled.shear_modulus() == relative(result.shear_modulus(), 5e-3));
    const ProbeResult fully =
        probe(state, material, mode, {.amplitude = 1e-8, .force_tolerance = 1e-300, .settled_share = 1e-5});
    CHECK(fully.converged);
    CHECK(fully.shear_modulus() == relative(result.shear_modulus(), 3e-4));
  }
  for (int axis = 0; axis < 3; ++axis) {
    Mat3 strain;
    strain(axis, axis) = 1;
    const Mat3 stress = swing(state, strain, 1e-8);
    for (int other = 0; other < 3; ++other)
      CHECK(std::abs(stress(other, other) - c(axis, other) - (other == axis ? 0 : pressure)) <
            2e-4 * c(axis, axis));
  }
}

TEST_CASE(
    "normal stresses kept constant by servos while walls tilt: the network's modulus at constant stress") {
  for (const Density density : {Density::dense, Density::loose}) {
    CAPTURE(density == Density::dense);
    const dem::Specimen& state = specimen(density);
    const Matrix6 c = test::frozen_network(state, material).response.relaxed().matrix;
    for (const ShearMode mode : {ShearMode::hh, ShearMode::hv, ShearMode::vh}) {
      const int k = mode == ShearMode::hh ? 5 : 4;
      const ProbeResult held = probe(state, material, mode, {.hold_normal_stress = true});
      CHECK(held.converged);
      CHECK(held.shear_modulus() == relative(held_modulus(c, k), 0.01));
      CHECK(held_modulus(c, k) <= c(k, k));
    }
  }
}

TEST_CASE("a loop: from the network's tangent, closed and elastic while it is tiny, wider as it grows") {
  const dem::Specimen& state = specimen(Density::dense);
  const Matrix6 c = test::frozen_network(state, material).response.relaxed().matrix;
  constexpr std::size_t points = 3;
  const auto loop = [&](double amplitude, double force_tolerance) {
    return probe(
        state, material, ShearMode::hv,
        {.amplitude = amplitude, .sliding = true, .loop_points = points, .force_tolerance = force_tolerance});
  };
  constexpr double fine = 1e-9; // forces change by some 1e-5 in the whole of the tiny cycle
  const ProbeResult tiny = loop(0, fine);
  REQUIRE(tiny.loop().size() == 5 * points + 1);
  CHECK(tiny.loop().front().shear_strain == 0);
  CHECK(tiny.loop().front().shear_stress == 0);
  CHECK(tiny.loop()[1].shear_stress / tiny.loop()[1].shear_strain == relative(c(4, 4), 0.02));
  CHECK(tiny.loop()[3 * points].shear_strain == relative(-tiny.amplitude, 1e-12));
  CHECK(std::abs(tiny.loop()[4 * points].shear_strain) < 1e-12 * tiny.amplitude);
  const auto swing_of = [&](const ProbeResult& r) {
    return r.loop()[points].shear_stress - r.loop()[3 * points].shear_stress;
  };
  CHECK(std::abs(tiny.loop().back().shear_stress - tiny.loop()[points].shear_stress) < 0.01 * swing_of(tiny));
  double last = 0;
  for (const double factor : {30.0, 300.0, 3000.0}) {
    const ProbeResult wide = loop(factor * tiny.amplitude, 1e-7);
    const double share = dissipation(wide, points) / (wide.amplitude * swing_of(wide));
    CHECK(share > last);
    last = share;
  }
  // Without loop points the same cycle, and none are kept.
  const ProbeResult plain = probe(state, material, ShearMode::hv, {.sliding = true, .force_tolerance = fine});
  CHECK(plain.loop().empty());
  CHECK(plain.shear_modulus() == relative(tiny.shear_modulus(), 0.01));
}
