// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/scene/scene_builder.hpp"

#include <granum/core/error.hpp>

namespace granum::studies {

namespace {

std::string ignored_text(const SceneKey& key, SceneCommand command) {
  std::string takers;
  for (const SceneCommand taker : key.commands)
    takers += (takers.empty() ? "" : ", ") + std::string(name(taker));
  return "key '" + key.name + "' would be ignored by " + std::string(name(command)) + "; it is for " + takers;
}

std::string without_effect_text(const SceneKey& key, const std::string& missing) {
  return "key '" + key.name + "' has no effect without " + missing;
}

} // namespace

void SceneBuilder::set(const std::string& name, const std::string& text) {
  const SceneKey& key = scene_key(name);
  if (!key.taken_by(command_))
    throw InvalidArgument(prefix_ + ignored_text(key, command_));
  key.set(scene_, text);
  alone_.push_back(&key);
}

void SceneBuilder::set_listed(const std::string& name, const std::string& text, std::size_t line) {
  const SceneKey& key = scene_key(name);
  Scene alone;
  key.set(alone, text);
  require_in_range(key, alone);
  const bool by_default = key.get(alone) == key.get(Scene{});
  if (!key.taken_by(command_)) {
    if (!by_default)
      throw InvalidArgument(ignored_text(key, command_));
    return;
  }
  key.set(scene_, text);
  if (!by_default)
    listed_.push_back({&key, line});
}

void SceneBuilder::end_list() {
  std::erase_if(listed_, [this](const Listed& one) { return one.key->missing(scene_).empty(); });
}

std::optional<SceneBuilder::WithoutEffect> SceneBuilder::without_effect() const {
  for (const SceneKey* key : alone_)
    if (const std::string missing = key->missing(scene_); !missing.empty())
      return WithoutEffect{prefix_ + without_effect_text(*key, missing), std::nullopt};
  for (const Listed& one : listed_)
    if (const std::string missing = one.key->missing(scene_); !missing.empty())
      return WithoutEffect{without_effect_text(*one.key, missing), one.line};
  return std::nullopt;
}

Scene SceneBuilder::finished() const {
  require_valid(scene_);
  if (const auto idle = without_effect())
    throw InvalidArgument(idle->message);
  return scene_;
}

} // namespace granum::studies
