// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/triaxial/specimen.hpp>

#include <granum/packing/forces.hpp>
#include <granum/sizes/distribution.hpp>

#include "dem/lattice_state.hpp"
#include "dem/stop_at.hpp"
#include "thresholds.hpp"
#include "unit.hpp"

using namespace granum::triaxial;

namespace {

SpecimenRecipe small_recipe() {
  SpecimenRecipe recipe{.material = test::quartz(0.5e-3, 0.4986), .radius = 0.5e-3};
  recipe.grains = 200;
  recipe.seed = 5;
  return recipe;
}

double coordination(const packing::Assembly& assembly) {
  return 2 * static_cast<double>(assembly.contacts.size()) / static_cast<double>(assembly.grain_count());
}

} // namespace

TEST_CASE("a frictionless specimen at its first pressure is just above the isostatic coordination") {
  const SpecimenRecipe recipe = small_recipe();
  const FrictionlessPacking preparation = frictionless_specimen(recipe);
  CHECK(preparation.last.converged);
  CHECK(preparation.last.pressure() == relative(10e3, 2e-5));
  CHECK(preparation.last.unbalanced_force_ratio < 1e-5);
  // Random close packing of equal spheres: solid fraction 0.62-0.65 at this size, six contacts a grain less
  // rattlers.
  const double solid_fraction = 1 / (1 + dem::void_ratio(preparation.state));
  CHECK(solid_fraction > 0.62);
  CHECK(solid_fraction < 0.65);
  const double c_n = coordination(dem::contact_network(preparation.state, recipe.material));
  CHECK(c_n > 5.6);
  CHECK(c_n < 6.3);
}

TEST_CASE("dense and loose specimens have almost one void ratio but not one coordination number") {
  const SpecimenRecipe recipe = small_recipe();
  const dem::Specimen jammed = frictionless_specimen(recipe).state;
  double c_n[2] = {}, e[2] = {};
  for (const Density density : {Density::dense, Density::loose})
    CHECK(isotropic_path(start_of_compression(jammed, density, recipe), recipe.material, {10e3},
                         compression_options(), [&](const Snapshot& snapshot) {
                           const auto kind = static_cast<std::size_t>(density);
                           c_n[kind] = coordination(dem::contact_network(snapshot.state, recipe.material));
                           e[kind] = dem::void_ratio(snapshot.state);
                           return true;
                         }));
  CHECK(c_n[0] - c_n[1] > 1.0);
  CHECK(e[1] - e[0] > 0);
  CHECK(e[1] - e[0] < 0.02);
}

TEST_CASE("the same recipe gives the same bits, another seed another packing, and a path can be taken up") {
  const SpecimenRecipe recipe = small_recipe();
  const dem::Specimen jammed = frictionless_specimen(recipe).state;
  CHECK(jammed == frictionless_specimen(recipe).state);
  SpecimenRecipe other = recipe;
  other.seed = 6;
  CHECK_FALSE(jammed == frictionless_specimen(other).state);

  const auto path = [&](const dem::Specimen& start, const std::vector<double>& pressures) {
    std::vector<dem::Specimen> states;
    CHECK(isotropic_path(start, recipe.material, pressures, compression_options(),
                         [&](const Snapshot& snapshot) {
                           states.push_back(snapshot.state);
                           return true;
                         }));
    return states;
  };
  const std::vector<dem::Specimen> straight = path(jammed, {10e3, 20e3, 30e3});
  const std::vector<dem::Specimen> resumed = path(straight.at(0), {20e3, 30e3});
  CHECK(straight.at(2) == resumed.at(1));
}

TEST_CASE("unequal grains are drawn from their distribution, keep their sizes, and jam") {
  SpecimenRecipe recipe = small_recipe();
  recipe.sizes = sizes::parse_distribution("uniform:1:2");
  const dem::Specimen jammed = frictionless_specimen(recipe).state;
  REQUIRE(jammed.size.size() == recipe.grains);
  CHECK(jammed.size == drawn_sizes(recipe));
  CHECK(dem::smallest_size(jammed) > 1 / 1.5);
  CHECK(dem::largest_size(jammed) < 2 / 1.5);
  CHECK(dem::largest_size(jammed) / dem::smallest_size(jammed) > 1.9);
  CHECK(
      dem::grain_volume(jammed) ==
      relative(200 * 4.0 / 3 * 3.14159265358979 * std::pow(recipe.radius, 3) * recipe.sizes.moment(3), 1e-3));
  const double c_n = coordination(dem::contact_network(jammed, recipe.material));
  CHECK(c_n > 5.2); // more rattlers than among equal grains
  CHECK(c_n < 6.3);
  const dem::Specimen opened = unjam(jammed, recipe);
  CHECK(opened.size == jammed.size);
  CHECK(opened.cell(1, 1) == relative((1 + recipe.unjamming_strain) * jammed.cell(1, 1), 1e-14));
  CHECK(contact_stress(dem::contact_network(opened, recipe.material)).mean() < 1e-3 * recipe.first_pressure);
  SpecimenRecipe other = recipe;
  other.seed = 6;
  CHECK(drawn_sizes(other) != drawn_sizes(recipe));
  CHECK(drawn_sizes(small_recipe()).empty());
}

TEST_CASE("grains of widely different sizes come to rest without friction") {
  // With unit masses in the minimiser this took 50,000 to 70,000 steps, and stopped far from the balance.
  SpecimenRecipe recipe = small_recipe();
  recipe.sizes = sizes::parse_distribution("power-law:4:7");
  recipe.grains = 900;
  recipe.first_pressure = 10e6;
  const FrictionlessPacking jammed = frictionless_specimen(recipe);
  CHECK(jammed.last.unbalanced_force_ratio < 1e-5);
  CHECK(jammed.minimiser_steps < 25000);
}

TEST_CASE("impossible recipes are refused by name") {
  SpecimenRecipe recipe = small_recipe();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [&](double SpecimenRecipe::*what, std::initializer_list<double> values) {
    for (const double value : values) {
      SpecimenRecipe bad = recipe;
      bad.*what = value;
      CHECK_THROWS_AS((void)frictionless_specimen(bad), InvalidArgument);
    }
  };
  for (const auto& [member, limit] : {std::pair(&SpecimenRecipe::radius, 1e-9),
                                      {&SpecimenRecipe::radius, 1e3},
                                      {&SpecimenRecipe::expansion_void_ratio, 0.4},
                                      {&SpecimenRecipe::expansion_void_ratio, 1.0},
                                      {&SpecimenRecipe::unjamming_strain, 0.1},
                                      {&SpecimenRecipe::agitation, 0.5}})
    check_threshold(limit, [&, what = member](double value) {
      SpecimenRecipe one = recipe;
      one.*what = value;
      return refusals([&] { require_valid(one); });
    });
  // The cell at e = 0.2 is wider than four of the largest grains, and the skin of the pair list.
  for (const char* text : {"bidisperse:20:0.5", "lognormal:0.5", "uniform:1:3"}) {
    const sizes::Distribution sizes = sizes::parse_distribution(text);
    const double width = 4 * sizes.largest() + 0.6, grains = static_cast<double>(least_grains(sizes));
    const auto edge = [&](double n) {
      return std::cbrt(n * 4 / 3 * std::numbers::pi * sizes.moment(3) * 1.2);
    };
    CHECK((edge(grains) >= width && (edge(grains - 1) < width || grains == 40)));
  }
  refused(&SpecimenRecipe::radius, {-1, 1e300, 1e-300});
  refused(&SpecimenRecipe::first_pressure, {0, nan});
  refused(&SpecimenRecipe::expansion_void_ratio, {-0.1});
  refused(&SpecimenRecipe::unjamming_strain, {0});
  refused(&SpecimenRecipe::agitation, {2});
  for (const char* sizes : {"equal", "bidisperse:20:0.5"}) {
    recipe.sizes = sizes::parse_distribution(sizes);
    recipe.grains = least_grains(recipe.sizes) - 1;
    CHECK_THROWS_AS((void)frictionless_specimen(recipe), InvalidArgument);
  }
}

TEST_CASE("preparation ends at the step at which it is asked to, in each of its stages") {
  const SpecimenRecipe recipe = small_recipe();
  const test::StopAt never(0);
  const FrictionlessPacking whole = frictionless_specimen(recipe, never);
  CHECK(never.asked() >= whole.minimiser_steps);
  for (const std::size_t question : {std::size_t{1}, never.asked() / 3, never.asked() - 1}) {
    const test::StopAt stop(question);
    CHECK_THROWS_AS((void)frictionless_specimen(recipe, stop), Stopped);
    CHECK(stop.asked() <= question + 1); // the stage after it may ask once more
  }
  const test::StopAt stop(3);
  CHECK_THROWS_AS((void)unjam(whole.state, recipe, stop), Stopped);
  CHECK(stop.asked() == 3);
}
