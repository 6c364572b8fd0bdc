// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/scene/scene.hpp"

#include <functional>

#include <granum/contact/grains.hpp>

#include "thresholds.hpp"
#include "unit.hpp"

using namespace granum::studies;
using contact::Shape;

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

} // namespace

// Ranges of single numbers: test_scene_keys.cpp.
TEST_CASE("lists that no study can have are refused by their names") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const std::vector<double>& wrong : {std::vector<double>{},
                                           {10e3, 20e3},
                                           {10e3, 30e3, 20e3},
                                           {10e3, 20e3, 20e3},
                                           {0, 10e3, 20e3},
                                           {-10e3, 10e3, 20e3},
                                           {10e3, nan, 20e3}})
    CHECK(refusal([&](Scene& s) { s.study.pressures = wrong; }).starts_with("study.pressures"));
  CHECK(refusal([](Scene& s) {
          s.study.probe_pressures = {10e3, 15e3};
        }).starts_with("study.probe_pressures"));
  for (const std::vector<Shape>& wrong :
       std::vector<std::vector<Shape>>{{}, {Shape::sphere, Shape::cone, Shape::sphere}})
    CHECK(refusal([&](Scene& s) { s.study.contacts = wrong; }).starts_with("study.contacts"));
  using triaxial::Density;
  for (const std::vector<Density>& wrong :
       std::vector<std::vector<Density>>{{}, {Density::loose, Density::loose}})
    CHECK(refusal([&](Scene& s) { s.study.densities = wrong; }).find("study.densities") != std::string::npos);
}

TEST_CASE("contacts that vanish or close the voids, lengths beyond a grain, and narrow boxes are refused") {
  struct Row {
    double limit, pressure; ///< at which it is reached
    std::vector<double> pressures;
  };
  for (const auto& [limit, pressure, pressures] :
       {Row{1e-9, 1, {1, 2, 3}}, Row{0.1, 100e3, {20e3, 50e3, 100e3}}})
    check_threshold(limit, [&, at = pressure, range = pressures](double value) {
      const double overlap = predicted_overlap(Scene{}, Shape::sphere, at);
      return refusal([&](Scene& s) {
               s.study.contacts = {Shape::sphere};
               s.study.pressures = range;
               s.study.probe_pressures = {};
               s.grain.shear_modulus *= std::pow(overlap / value, 1.5); // Hertz
             })
          .starts_with("study.pressures");
    });
  check_threshold(Scene{}.grain.radius, [](double radius) {
    return refusal([&](Scene& s) { s.contact.numbers["punch_radius"] = radius; }).starts_with("contact.");
  });
  for (const std::size_t grains : {154U, 155U}) // ten radii wide, with e = 0.55
    CHECK(refusal([&](Scene& s) {
            s.specimen.walls = true;
            s.study.grains = grains;
          }).starts_with("study.grains") == (grains == 154));
}

TEST_CASE("the contact laws are those of the scene") {
  Scene scene;
  scene.contact.numbers = {{"alpha", 3}, {"profile_constant", 5e6}};
  const contact::GrainMaterial grain{scene.grain.shear_modulus, scene.grain.poisson_ratio};
  for (const auto& [shape, expected] : {std::pair{Shape::cone, contact::PowerLaw::cone(grain, 0.4)},
                                        {Shape::sphere, contact::PowerLaw::sphere(grain, 0.5e-3)},
                                        {Shape::flat, contact::PowerLaw::flat(grain, 5.7e-6)},
                                        {Shape::power_law, contact::PowerLaw::general(grain, 3, 5e6)}}) {
    CHECK(law(scene, shape).force(1e-7) == expected.force(1e-7));
    CHECK(contact_exponent(scene, shape) == expected.stiffness_exponent());
  }
}

TEST_CASE("the recipe takes over every value of the scene, and threads are as asked, or one at least") {
  Scene scene;
  scene.grain.radius = 0.4e-3;
  scene.grain.sizes = sizes::Distribution::uniform(1, 1.5);
  scene.grain.density = 2700;
  scene.grain.friction_angle = 0.3;
  scene.study.grains = 77;
  scene.specimen.expansion_void_ratio = 0.6;
  scene.specimen.unjamming_strain = 0.004;
  scene.specimen.agitation = 0.05;
  scene.study.pressures = {5e3, 10e3, 20e3};
  const triaxial::SpecimenRecipe specimen = recipe(scene, Shape::sphere, 9);
  CHECK(specimen.radius == 0.4e-3);
  CHECK(specimen.sizes == sizes::Distribution::uniform(1, 1.5));
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
  const auto ratio = [&] { return recipe(scene, Shape::sphere, 9).material.tangential_ratio; };
  scene.grain.friction_angle = 0; // the network must not resist what the engine lets slide
  CHECK(ratio() == 0);
  scene.specimen = {.walls = true, .wall_friction = 0.1};
  CHECK(ratio() > 0);
  scene.specimen.walls = false;
  scene.grain.friction_angle = 0.3;
  scene.contact.tangential_ratio = 0;
  CHECK(ratio() == 0);
  CHECK(thread_count(scene) >= 1);
  scene.study.threads = 3;
  CHECK(thread_count(scene) == 3);
}
