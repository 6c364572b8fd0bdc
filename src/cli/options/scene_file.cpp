// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene_file.hpp"

#include <algorithm>

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <granum/core/error.hpp>
#include <granum/core/number.hpp>
#include <toml++/toml.h>

#include "scene_source.hpp"

namespace granum::cli {

namespace {

using studies::Scene;
using studies::SceneCommand;
using studies::SceneKey;

/// A TOML value as the text that --set would take.
std::string text_of(const toml::node& node, const std::string& path) {
  const auto line = node.source().begin.line;
  if (const auto* text = node.as_string())
    return text->get();
  if (const auto* integer = node.as_integer())
    return std::to_string(integer->get());
  if (const auto* number = node.as_floating_point())
    return exact_text(number->get());
  if (const auto* list = node.as_array()) {
    std::string joined;
    for (const toml::node& item : *list) {
      if (item.is_array() || item.is_table())
        throw FileError(path, line, "a list may hold texts and numbers only");
      joined += (joined.empty() ? "" : ",") + text_of(item, path);
    }
    return joined;
  }
  throw FileError(path, line, "expected a text such as \"0.5mm\", a number, or a list of them");
}

/// Calls take(name, node) for every key of a table, those of its sections as "section.key".
template <class Take>
void each_key(const toml::table& table, const std::string& prefix, const Take& take) {
  for (const auto& [key, node] : table) {
    const std::string name = prefix + std::string(key.str());
    if (const toml::table* section = node.as_table())
      each_key(*section, name + ".", take);
    else
      take(name, node);
  }
}

std::string ignored_text(const SceneKey& key, SceneCommand command) {
  std::vector<std::string> takers;
  for (const SceneCommand taker : key.commands)
    takers.emplace_back(name(taker));
  return fmt::format("key '{}' would be ignored by {}; it is for {}", key.name, name(command),
                     fmt::join(takers, ", "));
}

std::string without_effect_text(const SceneKey& key, const std::string& missing) {
  return fmt::format("key '{}' has no effect without {}", key.name, missing);
}

} // namespace

void SceneInput::take_from_file(const Given& given, const std::string& text) {
  const SceneKey& key = *given.key;
  Scene alone;
  try {
    key.set(alone, text);
    require_in_range(key, alone);
  } catch (const InvalidArgument& error) {
    throw FileError(given.path, given.line, error.what());
  }
  const bool by_default = key.get(alone) == key.get(Scene{});
  if (!key.taken_by(command_)) {
    if (!by_default)
      throw FileError(given.path, given.line, ignored_text(key, command_));
    return;
  }
  key.set(scene_, text);
  if (!by_default)
    unused_.push_back(given);
}

void SceneInput::read_file(const std::string& path) {
  const std::string text = read_scene_text(path);
  require_flat(text, path);
  toml::table table;
  try {
    table = toml::parse(text, path);
  } catch (const toml::parse_error& error) {
    throw FileError(path, error.source().begin.line, std::string(error.description()));
  }
  each_key(table, "", [&](const std::string& name, const toml::node& node) {
    const auto line = static_cast<std::size_t>(node.source().begin.line);
    const SceneKey* key = nullptr;
    try {
      key = &studies::scene_key(name);
    } catch (const InvalidArgument& error) {
      throw FileError(path, line, error.what());
    }
    take_from_file({key, path, line}, text_of(node, path));
  });
  std::erase_if(unused_, [this](const Given& given) { return given.key->missing(scene_).empty(); });
}

void SceneInput::set(const std::string& setting) {
  const std::size_t equals = setting.find('=');
  if (equals == std::string::npos)
    throw InvalidArgument("--set " + setting + ": expected key=value");
  const SceneKey& key = studies::scene_key(std::string(trimmed(setting.substr(0, equals))));
  if (!key.taken_by(command_))
    throw InvalidArgument("--set: " + ignored_text(key, command_));
  key.set(scene_, std::string(trimmed(setting.substr(equals + 1))));
  typed_.push_back({&key, {}, 0});
}

Scene SceneInput::finished() const {
  studies::require_valid(scene_);
  for (const Given& given : typed_)
    if (const std::string missing = given.key->missing(scene_); !missing.empty())
      throw InvalidArgument("--set: " + without_effect_text(*given.key, missing));
  for (const Given& given : unused_)
    if (const std::string missing = given.key->missing(scene_); !missing.empty())
      throw FileError(given.path, given.line, without_effect_text(*given.key, missing));
  return scene_;
}

Scene read_scene(const std::string& path, SceneCommand command) {
  SceneInput input(command, {});
  input.read_file(path);
  studies::require_valid(input.scene());
  return input.scene();
}

nlohmann::ordered_json json_of(const Scene& scene) {
  nlohmann::ordered_json json;
  for (const SceneKey& key : studies::scene_keys())
    std::visit([&](const auto& value) { json[key.section()][key.json_name] = value; }, key.resolved(scene));
  return json;
}

std::string key_help(SceneCommand command) {
  std::string text = "Keys of scenes and of --set:\n";
  for (const SceneKey& key : studies::scene_keys())
    if (key.taken_by(command))
      text += fmt::format("  {:<30} {}\n", key.name, key.description());
  return text;
}

} // namespace granum::cli
