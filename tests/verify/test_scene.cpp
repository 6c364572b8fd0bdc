// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/verify/scene.hpp>

#include <cmath>
#include <functional>
#include <limits>

#include <doctest/doctest.h>
#include <granum/contact/friction.hpp>
#include <granum/core/error.hpp>

#include "relative.hpp"

using namespace granum;
using namespace granum::verify;

namespace {

/// The message with which a scene is refused; empty if it is accepted.
std::string refusal(const std::function<void(Scene&)>& change) {
  Scene scene;
  change(scene);
  try {
    require_valid(scene);
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return {};
}

struct Refused {
  std::string begins;
  std::function<void(Scene&)> change;
};

} // namespace

TEST_CASE("the default scene is valid, and so is each contact alone") {
  CHECK(refusal([](Scene&) {}).empty());
  for (const Shape shape : {Shape::cone, Shape::sphere, Shape::flat, Shape::power_law})
    CHECK(refusal([&](Scene& s) { s.contacts = {shape}; }).empty());
}

TEST_CASE("the edges of what is allowed are allowed") {
  CHECK(refusal([](Scene& s) { s.grains = 40; }).empty());
  CHECK(refusal([](Scene& s) { s.grain_poisson_ratio = 0.5; }).empty());
  CHECK(refusal([](Scene& s) { s.friction_angle = 0; }).empty());
  CHECK(refusal([](Scene& s) { s.probe_pressures = {}; }).empty());
  CHECK(refusal([](Scene& s) { s.threads = 1024; }).empty());
  CHECK(refusal([](Scene& s) { s.seeds = 1000; }).empty());
  CHECK(refusal([](Scene& s) { s.tangential_ratio = 0; }).empty());
  CHECK(refusal([](Scene& s) {
          s.contacts = {Shape::power_law};
          s.alpha = 1;
        }).empty());
}

TEST_CASE("each value that no study can have is refused by its name") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Refused> cases{
      {"grains = 0 ", [](Scene& s) { s.grains = 0; }},
      {"grains = 1 ", [](Scene& s) { s.grains = 1; }},
      {"grains = 39 ", [](Scene& s) { s.grains = 39; }},
      {"seeds = 0 ", [](Scene& s) { s.seeds = 0; }},
      {"seeds = 1001 ", [](Scene& s) { s.seeds = 1001; }},
      {"threads = 1025 ", [](Scene& s) { s.threads = 1025; }},
      {"pressures: at least 3 ",
       [](Scene& s) {
         s.pressures = {10e3, 20e3};
       }},
      {"pressures: at least 3 ", [](Scene& s) { s.pressures = {}; }},
      {"pressures must rise",
       [](Scene& s) {
         s.pressures = {10e3, 30e3, 20e3};
       }},
      {"pressures must rise",
       [](Scene& s) {
         s.pressures = {10e3, 20e3, 20e3};
       }},
      {"pressures = 0 ",
       [](Scene& s) {
         s.pressures = {0, 10e3, 20e3};
       }},
      {"pressures = -10000 Pa",
       [](Scene& s) {
         s.pressures = {-10e3, 10e3, 20e3};
       }},
      {"pressures = ",
       [](Scene& s) {
         s.pressures = {10e3, nan, 20e3};
       }},
      {"probe_pressures = 15000 Pa",
       [](Scene& s) {
         s.probe_pressures = {10e3, 15e3};
       }},
      {"contacts and densities", [](Scene& s) { s.contacts = {}; }},
      {"contacts and densities", [](Scene& s) { s.densities = {}; }},
      {"contacts: sphere ",
       [](Scene& s) {
         s.contacts = {Shape::sphere, Shape::cone, Shape::sphere};
       }},
      {"densities: loose ",
       [](Scene& s) {
         s.densities = {triaxial::Density::loose, triaxial::Density::loose};
       }},
      {"grain_poisson_ratio = 0.6 ", [](Scene& s) { s.grain_poisson_ratio = 0.6; }},
      {"grain_poisson_ratio = -1 ", [](Scene& s) { s.grain_poisson_ratio = -1; }},
      {"grain_shear_modulus = 0 ", [](Scene& s) { s.grain_shear_modulus = 0; }},
      {"radius = -0.0005 ", [](Scene& s) { s.radius = -0.5e-3; }},
      {"radius = 0 ",
       [](Scene& s) {
         s.contacts = {Shape::cone};
         s.radius = 0;
       }},
      {"friction_angle = ", [](Scene& s) { s.friction_angle = std::numbers::pi / 2; }},
      {"friction_angle = ", [](Scene& s) { s.friction_angle = -0.1; }},
      {"density = 0 ", [](Scene& s) { s.density = 0; }},
      {"tangential_", [](Scene& s) { s.tangential_ratio = nan; }},
      {"slope = 0 ", [](Scene& s) { s.cone_slope = 0; }},
      {"slope = -0.4 ", [](Scene& s) { s.cone_slope = -0.4; }},
      {"punch_radius = 0 ", [](Scene& s) { s.punch_radius = 0; }},
      {"alpha = 0.9 ",
       [](Scene& s) {
         s.contacts = {Shape::power_law};
         s.alpha = 0.9;
       }},
      {"profile_constant = 0 ",
       [](Scene& s) {
         s.contacts = {Shape::power_law};
         s.profile_constant = 0;
       }},
      {"expansion_void_ratio = 0.4 ", [](Scene& s) { s.expansion_void_ratio = 0.4; }},
      {"unjamming_strain = 0 ", [](Scene& s) { s.unjamming_strain = 0; }},
      {"agitation = 0.6 ", [](Scene& s) { s.agitation = 0.6; }},
  };
  for (const Refused& one : cases) {
    const std::string message = refusal(one.change);
    INFO(one.begins, " | ", message);
    CHECK(message.starts_with(one.begins));
  }
}

TEST_CASE("the contact laws are those the scene says") {
  Scene scene;
  scene.alpha = 3;
  scene.profile_constant = 5e6;
  const contact::GrainMaterial grain{scene.grain_shear_modulus, scene.grain_poisson_ratio};
  const double overlap = 1e-7;
  const auto same = [&](Shape shape, const contact::PowerLaw& expected) {
    CHECK(law(scene, shape).force(overlap) == expected.force(overlap));
    CHECK(law(scene, shape).stiffness_exponent() == expected.stiffness_exponent());
  };
  same(Shape::cone, contact::PowerLaw::cone(grain, 0.4));
  same(Shape::sphere, contact::PowerLaw::sphere(grain, 0.5e-3));
  same(Shape::flat, contact::PowerLaw::flat(grain, 5.7e-6));
  same(Shape::power_law, contact::PowerLaw::general(grain, 3, 5e6));
  CHECK(law(scene, Shape::cone).stiffness_exponent() == relative(0.5, 1e-15));
  CHECK(law(scene, Shape::power_law).stiffness_exponent() == relative(0.25, 1e-15));
}

TEST_CASE("the recipe takes over every value of the scene") {
  Scene scene;
  scene.radius = 0.4e-3;
  scene.density = 2700;
  scene.friction_angle = 0.3;
  scene.grains = 77;
  scene.expansion_void_ratio = 0.6;
  scene.unjamming_strain = 0.004;
  scene.agitation = 0.05;
  scene.pressures = {5e3, 10e3, 20e3};
  const triaxial::SpecimenRecipe specimen = recipe(scene, Shape::sphere, 9);
  CHECK(specimen.radius == 0.4e-3);
  CHECK(specimen.material.density == 2700);
  CHECK(specimen.material.friction_coefficient == relative(std::tan(0.3), 1e-15));
  CHECK(specimen.grains == 77);
  CHECK(specimen.seed == 9);
  CHECK(specimen.expansion_void_ratio == 0.6);
  CHECK(specimen.unjamming_strain == 0.004);
  CHECK(specimen.agitation == 0.05);
  CHECK(specimen.first_pressure == 5e3);
  CHECK(specimen.material.law.force(1e-7) == law(scene, Shape::sphere).force(1e-7));
  // 2(1-nu)/(2-nu) at nu = 0.15
  CHECK(specimen.material.tangential_ratio == relative(34.0 / 37.0, 1e-15));
  scene.tangential_ratio = 0;
  CHECK(recipe(scene, Shape::sphere, 9).material.tangential_ratio == 0);
}

TEST_CASE("threads: as asked, or at least one") {
  Scene scene;
  CHECK(thread_count(scene) >= 1);
  scene.threads = 3;
  CHECK(thread_count(scene) == 3);
}

TEST_CASE("names are those of the command line") {
  CHECK(name(Shape::cone) == "cone");
  CHECK(name(Shape::sphere) == "sphere");
  CHECK(name(Shape::flat) == "flat");
  CHECK(name(Shape::power_law) == "power-law");
  CHECK(name(triaxial::Density::dense) == "dense");
  CHECK(name(triaxial::Density::loose) == "loose");
}
