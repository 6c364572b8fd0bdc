// SPDX-License-Identifier: GPL-3.0-or-later
// Two independent routes to the small-strain moduli of one frozen specimen: time stepping and linear algebra.
#include <granum/triaxial/probe.hpp>

#include <granum/network/linear_response.hpp>
#include <granum/packing/forces.hpp>
#include <granum/sizes/distribution.hpp>
#include <granum/triaxial/specimen.hpp>

#include "dem/lattice_state.hpp"
#include "dem/stop_at.hpp"
#include "measured_specimen.hpp"
#include "thresholds.hpp"
#include "unit.hpp"

using namespace granum::triaxial;

namespace {

SpecimenRecipe recipe_of(const contact::NormalLaw& law) {
  SpecimenRecipe recipe{.material = {.law = law,
                                     .tangential_ratio = contact::mindlin_stiffness_ratio(0.15),
                                     .friction_coefficient = 0.4986},
                        .radius = 0.5e-3};
  recipe.grains = 200;
  recipe.seed = 5;
  return recipe;
}

dem::Specimen compressed(const SpecimenRecipe& recipe, Density density, double pressure) {
  return test::compressed(recipe, density, {recipe.first_pressure, pressure});
}

} // namespace

TEST_CASE("probe and network agree on packings of unequal grains") {
  const struct {
    const char* sizes;
    Density density;
    std::uint64_t seed;
  } specimens[] = {{"lognormal:0.3", Density::dense, 5}, {"bidisperse:2.5:0.2", Density::dense, 5}};
  for (const auto& specimen : specimens) {
    CAPTURE(std::string(specimen.sizes));
    SpecimenRecipe recipe = recipe_of(test::quartz_sphere(0.5e-3));
    recipe.sizes = sizes::parse_distribution(specimen.sizes);
    recipe.grains = least_grains(recipe.sizes);
    recipe.seed = specimen.seed;
    const FrozenState frozen = freeze_in_place(compressed(recipe, specimen.density, 40e3), recipe.material);
    const packing::Assembly assembly = dem::contact_network(frozen.state(), recipe.material);
    const elastic::Matrix6 relaxed = network::linear_response(assembly).relaxed().matrix;
    const auto [hh, hv, vh] = probe_all(frozen.state(), recipe.material);
    CHECK(hh.shear_modulus() == relative(relaxed(5, 5), 0.01));
    CHECK(hv.shear_modulus() == relative(relaxed(4, 4), 0.01));
    CHECK(contact_stress(assembly).mean() == relative(40e3, 1e-3));
  }
}

TEST_CASE("probe and network agree on every shear modulus, and G_hv = G_vh") {
  const contact::GrainMaterial quartz{.shear_modulus = 30e9, .poisson_ratio = 0.15};
  const contact::NormalLaw sphere = contact::PowerLaw::sphere(quartz, 0.5e-3);
  const std::vector<contact::NormalLaw> laws{
      sphere, contact::PowerLaw::cone(quartz, 0.4), contact::PowerLaw::flat(quartz, 5.7e-6),
      contact::PowerLaw::general(quartz, 1.5, 180), contact::RoughSphere(quartz, 0.5e-3, 100e-9)};
  for (const contact::NormalLaw& law : laws)
    for (const Density density : {Density::dense, Density::loose}) {
      if (density == Density::loose && law != sphere)
        continue; // loose specimens take long to come to rest; one law will do
      const SpecimenRecipe recipe = recipe_of(law);
      const FrozenState frozen = freeze_in_place(compressed(recipe, density, 40e3), recipe.material);
      REQUIRE(frozen.report.converged());
      const auto network = network::linear_response(dem::contact_network(frozen.state(), recipe.material));
      const auto& relaxed = network.relaxed().matrix;
      const auto [hh, hv, vh] = probe_all(frozen.state(), recipe.material);
      // 1 %: the prestress terms that only the probe has, of the order overlap/R, times the softening of
      // weakly coordinated networks.
      CHECK(hh.shear_modulus() == relative(relaxed(5, 5), 0.01));
      CHECK(hv.shear_modulus() == relative(relaxed(4, 4), 0.01));
      CHECK(vh.shear_modulus() == relative(hv.shear_modulus(), 0.01));
      CHECK(hv.opening() < 0.02);
      if (!law.surface().begins_at_touch) { // where a contact begins does not matter
        packing::Assembly bearing = dem::contact_network(frozen.state(), recipe.material);
        const std::size_t all = bearing.contacts.size();
        const double mean =
            contact_stress(bearing).mean() * bearing.volume() / 1e-3 / static_cast<double>(all) * 3;
        std::erase_if(bearing.contacts,
                      [&](const packing::Contact& c) { return c.normal_force < 1e-3 * mean; });
        CHECK(bearing.contacts.size() < all);
        CHECK(network::linear_response(bearing).relaxed().matrix(5, 5) == relative(relaxed(5, 5), 1e-3));
      }
    }
}

TEST_CASE("a probe does not change the state it is given, and repeats to the bit") {
  const SpecimenRecipe recipe = recipe_of(test::quartz_sphere(0.5e-3));
  const dem::Specimen state = compressed(recipe, Density::dense, 20e3);
  const dem::Specimen copy = state;
  const ProbeResult first = probe(state, recipe.material, ShearMode::hh);
  CHECK(state == copy);
  CHECK(first.shear_modulus() == probe(state, recipe.material, ShearMode::hh).shear_modulus());
  const auto [hh, hv, vh] = probe_all(state, recipe.material);
  CHECK(state == copy);
  // Of the stress that is left at the end of the cycle the part that crept from end to end is taken out.
  const ProbeResult cycle = probe(state, recipe.material, ShearMode::hv, {.loop_points = 1});
  REQUIRE(cycle.loop().size() == 6);
  const double open = cycle.loop()[4].shear_stress,
               swing = cycle.loop()[1].shear_stress - cycle.loop()[3].shear_stress;
  const double crept = (2 * cycle.amplitude * cycle.shear_modulus() - swing) / open;
  CHECK((crept > 0.2 && crept < 0.8));
  CHECK(cycle.opening() == relative(std::abs(open / swing), 1e-9));
  dem::Material stuck = recipe.material;
  stuck.friction_coefficient = std::numeric_limits<double>::infinity();
  const dem::Engine engine(state, stuck);
  CHECK(cycle.amplitude ==
        relative(3e-5 * stuck.law.overlap(engine.figures().mean_normal_force) / engine.diameter(), 1e-12));
  CHECK(first.shear_modulus() == hh.shear_modulus());
  CHECK(probe(state, recipe.material, ShearMode::hv).shear_modulus() == hv.shear_modulus());
  CHECK(probe(state, recipe.material, ShearMode::vh).shear_modulus() == vh.shear_modulus());
}

TEST_CASE("a probe that does not come to rest gives no modulus, unless contacts may slide") {
  const SpecimenRecipe recipe = recipe_of(test::quartz_sphere(0.5e-3));
  const FrozenState frozen =
      freeze_in_place(compressed(recipe, Density::dense, 20e3), recipe.material, 1e-10);
  REQUIRE(frozen.report.converged());
  dem::Specimen disturbed = frozen.state();
  for (std::size_t g = 0; g < disturbed.grain_count(); g += 2)
    disturbed.position[g].x += 1e-3 * recipe.material.law.overlap(1.0);
  ProbeOptions hasty{.max_steps = 20};
  const ProbeResult at_start = probe(disturbed, recipe.material, ShearMode::hh, hasty);
  CHECK_FALSE(at_start.converged);
  CHECK_THROWS_AS((void)at_start.shear_modulus(), NotConverged);
  CHECK_THROWS_AS((void)at_start.opening(), NotConverged);
  CHECK_THROWS_AS((void)at_start.loop(), NotConverged);
  CHECK(at_start.last_shear_modulus == 0);
  CHECK(at_start.steps == 2 * hasty.max_steps);
  CHECK(at_start.unbalanced_force_ratio > hasty.force_tolerance);
  const ProbeResult in_first_leg = probe(frozen.state(), recipe.material, ShearMode::hh, hasty);
  CHECK_FALSE(in_first_leg.converged);
  CHECK(in_first_leg.last_shear_modulus == 0);
  CHECK(in_first_leg.steps == hasty.ramp_steps);
  hasty.sliding = true;
  const ProbeResult sliding = probe(disturbed, recipe.material, ShearMode::hh, hasty);
  CHECK_FALSE(sliding.converged);
  CHECK(sliding.last_shear_modulus != 0);
}

TEST_CASE("freezing keeps the friction of walls, and takes the steps that it may where nothing is enough") {
  SpecimenRecipe recipe = recipe_of(test::quartz_sphere(0.5e-3));
  recipe.grains = 60;
  recipe.wall_friction = 0.3;
  const dem::Specimen state = compressed(recipe, Density::dense, 20e3);
  dem::Specimen stuck = state;
  stuck.walls->friction_coefficient = std::numeric_limits<double>::infinity();
  dem::Material sticking = recipe.material;
  sticking.friction_coefficient = std::numeric_limits<double>::infinity();
  dem::Engine engine(stuck, sticking);
  const std::size_t first =
      dem::deform(engine, Mat3{}, 0, {.force_tolerance = 1e-5, .max_steps = 10000}).steps;
  const FrozenState frozen = freeze_in_place(state, recipe.material, 1e-300);
  CHECK(frozen.state().walls.value().friction_coefficient == 0.3);
  CHECK(frozen.report.steps == first + 10000 + 20000);
}

TEST_CASE("freezing takes far fewer steps than drag alone, to the same stress and moduli") {
  const SpecimenRecipe recipe = recipe_of(test::quartz_sphere(0.5e-3));
  dem::Material sticking = recipe.material;
  sticking.friction_coefficient = std::numeric_limits<double>::infinity();
  const dem::Specimen state = compressed(recipe, Density::loose, 20e3);
  dem::Engine engine(state, sticking);
  const dem::QuasistaticReport alone =
      dem::deform(engine, Mat3{}, 0, {.force_tolerance = usual_force_tolerance});
  REQUIRE(alone.converged());
  const FrozenState frozen = freeze_in_place(state, recipe.material);
  REQUIRE(frozen.report.converged());
  CHECK(frozen.force_tolerance == 1e-8);
  CHECK(5 * frozen.report.steps < 4 * alone.steps);
  CHECK(trace(frozen.stress()) == relative(trace(alone.stress()), 1e-4));
  const auto G_hh = [&](const dem::Specimen& at_rest) {
    return network::linear_response(dem::contact_network(at_rest, recipe.material)).relaxed().matrix(5, 5);
  };
  CHECK(G_hh(frozen.state()) == relative(G_hh(engine.state()), 1e-3));
}

TEST_CASE("a frozen state that is not at rest is available only by its other name") {
  FrozenState frozen;
  frozen.force_tolerance = 1e-8;
  frozen.report.unbalanced_force_ratio = 1.1e-6;
  CHECK_FALSE(frozen.at_rest());
  CHECK_THROWS_AS((void)frozen.state(), NotConverged);
  CHECK_THROWS_AS((void)frozen.stress(), NotConverged);
  frozen.report.unbalanced_force_ratio = rest_bound; // an escaping rattler is allowed for
  CHECK(frozen.at_rest());
  CHECK_NOTHROW((void)frozen.state());
  frozen.force_tolerance = creeping_force_tolerance;
  check_threshold(1e-4, [&](double ratio) {
    frozen.report.unbalanced_force_ratio = ratio;
    return frozen.at_rest() ? 1 : 0;
  });
  frozen.report.unbalanced_force_ratio = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(frozen.at_rest());
}

TEST_CASE("rest and probes end at the step at which they are asked to") {
  const SpecimenRecipe recipe = recipe_of(contact::PowerLaw::sphere({30e9, 0.15}, 0.5e-3));
  const dem::Specimen state = compressed(recipe, Density::dense, 20e3);
  const auto stops = [](const auto& work) {
    const test::StopAt never(0);
    work(never);
    REQUIRE(never.asked() > 10);
    for (const std::size_t question : {std::size_t{1}, never.asked() / 2, never.asked() - 1}) {
      const test::StopAt stop(question);
      CHECK_THROWS_AS(work(stop), Stopped);
      CHECK(stop.asked() <= question + 2); // a rest has two turns, each of which asks
    }
  };
  stops([&](const test::StopAt& stop) { (void)freeze_in_place(state, recipe.material, 1e-8, stop); });
  const dem::Specimen frozen = freeze_in_place(state, recipe.material).state();
  stops([&](const test::StopAt& stop) {
    (void)probe(frozen, recipe.material, ShearMode::vh, {.stop_requested = stop});
  });
  stops(
      [&](const test::StopAt& stop) { (void)probe_all(frozen, recipe.material, {.stop_requested = stop}); });
}
