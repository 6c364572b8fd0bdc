// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/dem/specimen.hpp>
#include <granum/packing/forces.hpp>
#include <granum/triaxial/probe.hpp>
#include <granum/triaxial/shear_test.hpp>
#include <granum/triaxial/specimen.hpp>

#include "dem/lattice_state.hpp"
#include "measured_specimen.hpp"
#include "unit.hpp"

using namespace granum::triaxial;
using namespace granum::stress;

namespace {

using test::material;
using test::pressure;
using test::radius;

/// A dense specimen between smooth walls, made once.
const dem::Specimen& specimen() {
  static const dem::Specimen made = [] {
    SpecimenRecipe recipe{.material = material, .radius = radius, .grains = 400, .seed = 2};
    recipe.wall_friction = 0;
    return test::compressed(recipe, Density::dense, {pressure});
  }();
  return made;
}

} // namespace

TEST_CASE("a specimen between walls: the walls carry the pressure, and so does its interior") {
  const dem::Engine engine(specimen(), material);
  for (int axis = 0; axis < 3; ++axis) {
    CHECK(engine.figures().boundary_stress[axis] == relative(pressure, 2e-5));
    // At rest an identity; residual forces are 1e-5 of the mean one.
    CHECK(engine.figures().stress(axis, axis) == relative(pressure, 1e-3));
  }
  for (const double nothing : {10 * radius, -radius})
    CHECK_THROWS_AS((void)test::measured(specimen(), material, {.interior_layer = nothing}), InvalidArgument);
  const analysis::InteriorMeasures interior =
      test::measured(specimen(), material, {.interior_layer = 3 * radius}).interior.value();
  CHECK(interior.grains > 60);
  CHECK(interior.grains < 200);
  // Within R of a side wall stand no contacts between grains: the rest of the section, (L - 2 R)^2 of L^2 or
  // somewhat more, bears the force of the whole wall. Sixty grains are a small sample: 20 %.
  const double edge = std::cbrt(determinant(specimen().cell));
  const double crowding = std::pow(edge / (edge - 2 * radius), 2);
  CHECK(trace(interior.stress) / 3 > 0.8 * pressure);
  CHECK(trace(interior.stress) / 3 < 1.2 * crowding * pressure);
  // With no layer left out the interior is all there is between the grains.
  const analysis::InteriorMeasures all =
      test::measured(specimen(), material, {.interior_layer = 0}).interior.value();
  const packing::Assembly assembly = dem::contact_network(specimen(), material);
  const analysis::Microstructure whole = test::measured(specimen(), material).microstructure();
  CHECK(all.grains == 400);
  CHECK(all.micro.coordination_number == relative(whole.coordination_number, 1e-14));
  CHECK(all.micro.mechanical_coordination_number == relative(whole.mechanical_coordination_number, 1e-14));
  CHECK(all.micro.fabric_anisotropy == relative(whole.fabric_anisotropy, 1e-12));
  const packing::ContactStress stress = contact_stress(assembly);
  for (int axis = 0; axis < 3; ++axis)
    CHECK(all.stress(axis, axis) == relative(stress.tensor(axis, axis), 1e-12));
  // Of the overlaps with the walls, 1e-3 of the radius deep, small caps are missing.
  CHECK(all.void_ratio == relative(dem::void_ratio(specimen()), 1e-4));
  CHECK(all.void_ratio >= dem::void_ratio(specimen()));
  // The gaps at plane walls are left out with the layer there.
  CHECK(interior.void_ratio < all.void_ratio - 0.05);
  CHECK(interior.void_ratio > 0.5);
  // Grains at a wall have lost the contacts that they would have beyond it.
  CHECK(interior.micro.coordination_number > whole.coordination_number + 0.3);
}

TEST_CASE("between walls a stress path is followed by the wall stress, to its peak and past it") {
  ShearOptions options;
  options.path = ShearPath::txc;
  options.mean_stress = pressure;
  options.largest_strain = 0.0025;
  ShearTest test(specimen(), material, options);
  while (test.advance() == ShearEvent::snapshot) {
    const AxialStress on_path = stress_on_path(options.path, pressure, test.now().stress.ratio());
    CHECK(test.now().stress.v == relative(on_path.v, 0.03));
    CHECK(test.now().stress.h == relative(on_path.h, 0.03));
  }
  CHECK(test.peak().step < test.now().step);
  // Smooth walls and the loose layers at them take some degrees from the 26 of a periodic cell.
  const double degree = std::numbers::pi / 180;
  CHECK(mobilised_friction_angle(test.peak().stress) > 18 * degree);
  CHECK(mobilised_friction_angle(test.peak().stress) < 28 * degree);
  const dem::StepFigures& figures = test.engine().figures();
  // In motion the grains' own forces are out of balance by less than 1 %.
  CHECK(figures.stress(2, 2) == relative(figures.boundary_stress.z, 0.02));
}
