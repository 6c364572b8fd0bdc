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

/// A TOML value as a text for --set.
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
        throw FileError(path, line, "a list may contain texts and numbers only");
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

} // namespace

void SceneInput::read_file(const std::string& path) {
  const std::string text = read_scene_text(path);
  require_flat(text, path);
  toml::table table;
  try {
    table = toml::parse(text, path);
  } catch (const toml::parse_error& error) {
    throw FileError(path, error.source().begin.line, std::string(error.description()));
  }
  path_ = path;
  each_key(table, "", [&](const std::string& name, const toml::node& node) {
    const auto line = static_cast<std::size_t>(node.source().begin.line);
    try {
      (void)studies::scene_key(name); // an unknown key is reported before a wrong kind of value
      builder_.set_listed(name, text_of(node, path), line);
    } catch (const InvalidArgument& error) {
      throw FileError(path, line, error.what());
    }
  });
  builder_.end_list();
}

void SceneInput::set(const std::string& setting) {
  const std::size_t equals = setting.find('=');
  if (equals == std::string::npos)
    throw InvalidArgument("--set " + setting + ": expected key=value");
  builder_.set(std::string(trimmed(setting.substr(0, equals))),
               std::string(trimmed(setting.substr(equals + 1))));
}

Scene SceneInput::finished() {
  studies::require_valid(builder_.scene());
  if (const auto idle = builder_.without_effect(); idle && idle->line)
    throw FileError(path_, *idle->line, idle->message);
  return builder_.finished();
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
