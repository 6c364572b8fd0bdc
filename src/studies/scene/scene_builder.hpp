// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "studies/scene/scene_keys.hpp"

/// Makes a scene key by key, from programs and scripts.
namespace granum::studies {

/// A scene made of defaults and keys, for one command. A key that the command would ignore is refused:
/// - one that is set by itself always;
/// - one of a list, such as a scene file, unless it has its default, so that one list serves all
///   commands.
/// So is a key that the other keys leave without effect, such as a cone's slope without cones: of a list
/// where that holds with the list alone as well as in the end.
/// Checked by tests/studies/test_scene_builder.cpp
class SceneBuilder {
 public:
  /// \param    prefix   beginning of messages about single keys, "--set: "
  SceneBuilder(SceneCommand command, const Scene& defaults, std::string prefix = "")
      : command_(command), scene_(defaults), prefix_(std::move(prefix)) {}

  /// Sets a key by itself.
  /// \throws   InvalidArgument for an unknown key, invalid text, or a key without effect
  void set(const std::string& name, const std::string& text);
  /// Sets a key of a list.
  /// \param    line   of the key, for messages
  /// \throws   InvalidArgument as set, and for a value out of its range
  void set_listed(const std::string& name, const std::string& text, std::size_t line = 0);
  /// Ends the list: keys that have an effect within it are not checked again.
  void end_list();

  /// The keys given so far, for options that set a key themselves.
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
