// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "studies/scene/scene_keys.hpp"

/// Scenes put together key by key, which is how programs and scripts give them.
namespace granum::studies {

/// A scene made of defaults and keys, for one command. A key that the command would ignore is refused:
/// - one that is set by itself always;
/// - one of a list, as scene files are, unless it stands at its default, so that one list serves all
///   commands.
/// So is a key that the other keys leave without effect, such as a cone's slope without cones: of a list
/// where that holds with the list alone as well as in the end.
/// Checked by tests/studies/test_scene_builder.cpp
class SceneBuilder {
 public:
  /// \param    prefix   what messages on keys set by themselves begin with, "--set: "
  SceneBuilder(SceneCommand command, const Scene& defaults, std::string prefix = "")
      : command_(command), scene_(defaults), prefix_(std::move(prefix)) {}

  /// Sets a key by itself.
  /// \throws   InvalidArgument for an unknown key, text that it cannot take, or a key that would be ignored
  void set(const std::string& name, const std::string& text);
  /// Sets a key of a list.
  /// \param    line   where it stands there, for messages
  /// \throws   InvalidArgument as set, and for a value out of its range
  void set_listed(const std::string& name, const std::string& text, std::size_t line = 0);
  /// The list is read: what has an effect within it is not asked for one later.
  void end_list();

  /// What is given so far, for options that set a key of their own.
  [[nodiscard]] Scene& scene() { return scene_; }

  /// A key that was given and has no effect.
  struct WithoutEffect {
    std::string message;
    std::optional<std::size_t> line; ///< of a list
  };
  /// The first of them.
  [[nodiscard]] std::optional<WithoutEffect> without_effect() const;

  /// The scene, checked as a whole.
  /// \throws   InvalidArgument as require_valid, and for a key without effect
  [[nodiscard]] Scene finished() const;

 private:
  struct Listed {
    const SceneKey* key;
    std::size_t line;
  };

  SceneCommand command_;
  Scene scene_;
  std::string prefix_;
  std::vector<const SceneKey*> alone_;
  std::vector<Listed> listed_; ///< those away from their defaults
};

} // namespace granum::studies
