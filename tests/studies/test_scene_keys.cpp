// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/scene/scene_keys.hpp"

#include <fstream>
#include <functional>
#include <set>
#include <sstream>

#include "studies/verify/study.hpp"
#include <granum/core/text.hpp>
#include <granum/sizes/distribution.hpp>

#include "unit.hpp"

using namespace granum::studies;
using contact::Shape;

namespace {

/// A value as --set takes it: no quotes, no brackets.
std::string typed(const KeyValue& value, Dimension dimension) {
  std::string text = toml_text(value, dimension);
  std::erase_if(text, [](char c) { return c == '"' || c == '[' || c == ']'; });
  return text;
}

std::string typed(double value, const SceneKey& key) { return typed(KeyValue(value), key.dimension); }

bool is_quantity(const SceneKey& key) {
  return key.range.low != key.range.high && !std::holds_alternative<std::uint64_t>(key.get(Scene{}));
}

/// The message of what is refused; empty if nothing is.
std::string refusal(const std::function<void()>& work) {
  try {
    work();
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return {};
}

std::string file_text(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

} // namespace

TEST_CASE("keys have meanings and takers, each name once and in its section") {
  std::set<std::string> names, json_names;
  for (const SceneKey& key : scene_keys()) {
    CAPTURE(key.name);
    CHECK(names.insert(key.name).second);
    CHECK(json_names.insert(key.section() + "/" + key.json_name).second);
    CHECK(key.json_name.starts_with(key.name_in_section()));
    CHECK_FALSE(key.meaning.empty());
    CHECK(key.taken_by(SceneCommand::reproduce));
    CHECK(&scene_key(key.name) == &key);
  }
  for (const char* unknown : {"grain.radios", ""})
    CHECK_THROWS_AS((void)scene_key(unknown), InvalidArgument);
}

TEST_CASE("the text of a key is read back to the bit") {
  Scene changed;
  changed.grain.radius = 0.1e-3 * std::sqrt(2.0);
  changed.grain.friction_angle = 1.0 / 3;
  changed.grain.sizes = sizes::parse_distribution("lognormal:0.35");
  changed.contact.tangential_ratio = 1.0 / 7;
  changed.study.contacts = {Shape::power_law};
  changed.study.first_seed = 9'000'000'000'000'000;
  changed.study.pressures = {1e3 / 3, 1e4 / 3, 1e5 / 3};
  changed.study.probe_pressures = {};
  changed.specimen.walls = true;
  changed.shear.paths = {};
  for (const Scene& scene : {Scene{}, changed}) {
    Scene copy;
    for (const SceneKey& key : scene_keys())
      key.set(copy, typed(key.get(scene), key.dimension));
    for (const SceneKey& key : scene_keys()) {
      CAPTURE(key.name);
      CHECK(key.get(copy) == key.get(scene));
    }
    CHECK(toml_of(copy) == toml_of(scene));
  }
}

TEST_CASE("a tangential ratio that is not given is Mindlin's by name, and its number when computed with") {
  const SceneKey& key = scene_key("contact.tangential_ratio");
  Scene scene;
  CHECK(key.get(scene) == KeyValue(std::string("mindlin")));
  CHECK(std::get<double>(key.resolved(scene)) == tangential_ratio(scene));
  key.set(scene, "0.5");
  CHECK(key.resolved(scene) == KeyValue(0.5));
  key.set(scene, "mindlin");
  CHECK_FALSE(scene.contact.tangential_ratio.has_value());
}

TEST_CASE(
    "every number has a range with a reason, which holds its default, its closed ends and nothing beyond") {
  for (const SceneKey& key : scene_keys()) {
    CAPTURE(key.name);
    CHECK(refusal([&] { require_in_range(key, Scene{}); }).empty());
    if (!is_quantity(key))
      continue;
    CHECK_FALSE(key.range.reason.empty());
    const auto answer = [&](double value) {
      Scene scene;
      key.set(scene, typed(value, key));
      return refusal([&] { require_in_range(key, scene); });
    };
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double below = key.range.low_open ? key.range.low : std::nextafter(key.range.low, -infinity);
    const double above = key.range.high_open ? key.range.high : std::nextafter(key.range.high, infinity);
    CHECK(answer(below).starts_with(key.name + " = "));
    CHECK(answer(above).find(text(key.range, key.dimension)) != std::string::npos);
    if (!key.range.low_open)
      CHECK(answer(key.range.low).empty());
    if (!key.range.high_open)
      CHECK(answer(key.range.high).empty());
  }
}

TEST_CASE("a list may be in brackets, and [] is the empty one, for every key that is a list") {
  std::size_t lists = 0;
  for (const SceneKey& key : scene_keys()) {
    CAPTURE(key.name);
    Scene scene;
    const auto entries = [&]() -> std::optional<std::size_t> {
      const KeyValue value = key.get(scene);
      if (const auto* numbers = std::get_if<std::vector<double>>(&value))
        return numbers->size();
      const auto* words = std::get_if<std::vector<std::string>>(&value);
      return words == nullptr ? std::nullopt : std::optional(words->size());
    };
    if (!entries())
      continue;
    ++lists;
    key.set(scene, "[]");
    CHECK(entries() == 0);
  }
  CHECK(lists >= 5);
  Scene scene;
  scene_key("study.pressures").set(scene, " [10kPa, 20kPa] ");
  CHECK(scene.study.pressures == std::vector{1e4, 2e4});
  const SceneKey& key = scene_key("study.first_seed"); // whole numbers from 0 on
  for (const char* seed : {"-1", "1.5"})
    CHECK(refusal([&] { key.set(scene, seed); }).find(text(key.range, key.dimension)) != std::string::npos);
}

TEST_CASE("each command takes the keys that it uses") {
  for (const SceneCommand command : all_scene_commands) {
    CAPTURE(name(command));
    const auto takes = [&](const char* key) { return scene_key(key).taken_by(command); };
    for (const char* key :
         {"specimen.boundary", "specimen.wall_friction", "shear.paths", "shear.loop_strain"})
      CHECK(takes(key) == (command == SceneCommand::reproduce));
    for (const char* key :
         {"grain.radius", "grain.sizes", "contact.alpha", "study.grains", "specimen.agitation"})
      CHECK(takes(key));
    CHECK(takes("study.probe_pressures") == (command != SceneCommand::trade));
  }
}

TEST_CASE("a key without effect names the missing condition") {
  const auto missing = [](const char* key, const Scene& scene) { return scene_key(key).missing(scene); };
  Scene scene;
  CHECK(missing("contact.cone_slope", scene).empty());
  CHECK(missing("contact.alpha", scene).find("study.contacts") != std::string::npos);
  CHECK(missing("specimen.wall_friction", scene) == "specimen.boundary = walls");
  scene.study.contacts = {Shape::power_law};
  scene.study.densities = {triaxial::Density::dense};
  scene.specimen.walls = true;
  scene.shear.paths = {};
  CHECK(missing("contact.cone_slope", scene).find("study.contacts") != std::string::npos);
  CHECK(missing("contact.punch_radius", scene).find("study.contacts") != std::string::npos);
  CHECK(missing("contact.alpha", scene).empty());
  CHECK(missing("specimen.agitation", scene).find("study.densities") != std::string::npos);
  CHECK(missing("specimen.wall_friction", scene).empty());
  CHECK(missing("shear.eta_step", scene).find("shear.paths") != std::string::npos);
}

TEST_CASE("examples/scene.toml agrees with the table") {
  const std::string expected = commented_default_toml();
  std::ofstream(GRANUM_SCENE_OF_TABLE) << expected;
  INFO("copy " GRANUM_SCENE_OF_TABLE " to examples/scene.toml");
  CHECK(file_text(GRANUM_EXAMPLES "/scene.toml") == expected);
}

TEST_CASE("pressures at which contacts vanish or grains close the voids are refused by the overlap that is "
          "predicted") {
  const auto answer = [](Shape shape, double pressure) {
    Scene scene;
    scene.study.contacts = {shape};
    scene.study.pressures = {pressure, 2 * pressure, 3 * pressure};
    scene.study.probe_pressures = {};
    return refusal([&] { require_valid(scene); });
  };
  for (const contact::LawRow& row : contact::laws()) {
    CAPTURE(name(row.shape));
    CHECK(answer(row.shape, 10e3).empty());
    CHECK(answer(row.shape, 4e9).starts_with("study.pressures"));
  }
  CHECK(answer(Shape::flat, 1e-3).starts_with("study.pressures"));
  CHECK(answer(Shape::sphere, 1e-5).starts_with("study.pressures"));
  // f = 4 pi R^2 (1+e) p/C_n on a grain, d = (3(1-nu) f/(2 G sqrt(2R)))^(2/3).                   [Hertz1882]
  const Scene scene;
  const double R = 0.5e-3, force = 4 * std::numbers::pi * R * R * 1.558 * 100e3 / 5.73;
  const double overlap = std::pow(3 * 0.85 * force / (2 * 30e9 * std::sqrt(2 * R)), 2.0 / 3);
  CHECK(predicted_overlap(scene, Shape::sphere, 100e3) == doctest::Approx(overlap / (2 * R)).epsilon(1e-12));
}

TEST_CASE("grains at both ends of the range of radii, stiff and soft, light and heavy, can be run") {
  const struct {
    double radius, shear_modulus, density;
  } extremes[] = {{1e-9, 1e15, 1e-6}, {1e-9, 1, 1e18}, {1e3, 1e15, 1e18}, {1e3, 1, 1e-6}};
  std::vector<double> relative_moduli;
  for (const auto& [radius, modulus, density] : extremes) {
    Scene scene;
    scene.grain.radius = radius;
    scene.grain.shear_modulus = modulus;
    scene.grain.density = density;
    scene.study.contacts = {Shape::sphere};
    scene.study.densities = {triaxial::Density::dense};
    scene.study.grains = 60;
    scene.study.pressures = {1e-6 * modulus, 2e-6 * modulus, 4e-6 * modulus};
    scene.study.probe_pressures = {scene.study.pressures.back()};
    const std::vector<SpecimenResult> results = run_study(scene);
    REQUIRE(results.size() == 1);
    CHECK(results.front().failure == "");
    REQUIRE(results.front().states.size() == 3);
    // Only ratios of the three enter: all are the same packing in other units.
    const CompressedState& last = results.front().states.back();
    CHECK(last.packing.void_ratio == relative(0.575, 0.13));
    relative_moduli.push_back(last.network().shear_modulus() / modulus);
    CHECK(relative_moduli.back() == relative(relative_moduli.front(), 0.01));
    REQUIRE(last.probes.has_value());
    CHECK(last.probes->G_hv / last.network().shear_modulus() == relative(1, 0.3));
  }
}

TEST_CASE("a study in the periodic cell refuses walls, and a scene sizes that it cannot take, by name") {
  Scene scene;
  scene.specimen.walls = true;
  CHECK(refusal([&] { (void)run_study(scene); }).find("specimen.boundary") != std::string::npos);
  const SceneKey& key = scene_key("grain.sizes");
  CHECK(refusal([&] { key.set(scene, "sieve:1mm=0:2mm=1"); }).starts_with("grain.sizes"));
  CHECK(refusal([&] { key.set(scene, "normal:3"); }).find("lognormal") != std::string::npos);
  key.set(scene, "uniformity:2.5");
  scene.specimen.walls = false;
  scene.study.grains = 40;
  CHECK(refusal([&] { require_valid(scene); }).find("grains = 40") != std::string::npos);
}
