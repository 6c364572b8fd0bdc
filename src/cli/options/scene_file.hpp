// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "studies/scene/scene_keys.hpp"
#include <nlohmann/json.hpp>

namespace granum::cli {

/// A scene put together from defaults, a scene file and --set, for one command. A key that the command would
/// ignore is refused:
/// - from --set always;
/// - from a file unless it stands at its default, so that one file serves all commands.
/// So is a key that the other keys leave without effect, such as a cone's slope without cones: from --set,
/// and from a file where that holds with the file alone as well as in the end.
class SceneInput {
 public:
  SceneInput(studies::SceneCommand command, const studies::Scene& defaults)
      : command_(command), scene_(defaults) {}

  /// \throws   FileError with path and line for what cannot be read, an unknown key, a value it cannot take,
  ///           or a key that the command would ignore
  void read_file(const std::string& path);
  /// "key=value" of --set.
  /// \throws   InvalidArgument
  void set(const std::string& setting);

  /// What is given so far, for options that set a key of their own.
  [[nodiscard]] studies::Scene& scene() { return scene_; }

  /// The scene, checked as a whole.
  /// \throws   InvalidArgument, FileError
  [[nodiscard]] studies::Scene finished() const;

 private:
  struct Given {
    const studies::SceneKey* key;
    std::string path; ///< of the file; empty for --set
    std::size_t line;
  };
  void take_from_file(const Given& given, const std::string& text);

  studies::SceneCommand command_;
  studies::Scene scene_;
  std::vector<Given> typed_;  ///< by --set
  std::vector<Given> unused_; ///< of the file, without effect within it
};

/// The scene that an earlier run of a command has stored, whole: it may hold keys without effect.
/// \throws   FileError, InvalidArgument
[[nodiscard]] studies::Scene read_scene(const std::string& path, studies::SceneCommand command);

/// The resolved scene in SI, for manifests.
[[nodiscard]] nlohmann::ordered_json json_of(const studies::Scene& scene);
/// The keys that a command takes, with meaning and range, for help.
[[nodiscard]] std::string key_help(studies::SceneCommand command);

} // namespace granum::cli
