// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/scene/scene_builder.hpp"

#include <functional>

#include "unit.hpp"

using namespace granum::studies;

namespace {

std::string refused(const std::function<void()>& work) {
  try {
    work();
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return {};
}

SceneBuilder builder(SceneCommand command = SceneCommand::verify) { return {command, Scene{}, "--set: "}; }

} // namespace

TEST_CASE("a scene contains the given keys, those of a list only within their range") {
  SceneBuilder scene = builder();
  scene.set("study.grains", "300");
  scene.set_listed("grain.radius", "0.25mm");
  CHECK(scene.finished().study.grains == 300);
  CHECK(scene.finished().grain.radius == 0.25e-3);
  CHECK(refused([&] { scene.set_listed("grain.radius", "-1mm"); }).starts_with("grain.radius = "));
  CHECK(refused([&] { scene.set_listed("grain.colour", "red"); }) != "");
}

TEST_CASE("a key that the command would ignore is refused, in a list unless it has its default") {
  for (const SceneKey& key : scene_keys()) {
    if (key.taken_by(SceneCommand::verify))
      continue;
    CAPTURE(key.name);
    std::string by_default = toml_text(key.get(Scene{}), key.dimension);
    std::erase_if(by_default, [](char c) { return c == '"' || c == '[' || c == ']'; });
    SceneBuilder scene = builder();
    scene.set_listed(key.name, by_default);
    CHECK_NOTHROW((void)scene.finished());
    CHECK(refused([&] { scene.set(key.name, by_default); }).find(key.name) != std::string::npos);
  }
  SceneBuilder scene = builder();
  CHECK(refused([&] { scene.set_listed("shear.paths", "TXC"); }).find("shear.paths") != std::string::npos);
}

TEST_CASE(
    "a key without effect is refused in the end, one that a key given separately deprives of it is not") {
  SceneBuilder scene = builder();
  scene.set_listed("study.contacts", "sphere", 3);
  scene.set_listed("contact.cone_slope", "0.3", 7);
  scene.end_list();
  REQUIRE(scene.without_effect());
  CHECK(scene.without_effect()->line == 7);
  CHECK(refused([&] { (void)scene.finished(); }).find("contact.cone_slope") != std::string::npos);
  scene.set("study.contacts", "cone,sphere");
  CHECK_FALSE(scene.without_effect());
  CHECK(scene.finished().contact.numbers.at("cone_slope") == 0.3);

  SceneBuilder other = builder();
  other.set_listed("contact.cone_slope", "0.3", 7);
  other.end_list();
  other.set("study.contacts", "sphere");
  CHECK_NOTHROW((void)other.finished());
  other.set("contact.cone_slope", "0.4");
  CHECK(other.without_effect()->line == std::nullopt);
  CHECK(refused([&] { (void)other.finished(); }).find("contact.cone_slope") != std::string::npos);
}
