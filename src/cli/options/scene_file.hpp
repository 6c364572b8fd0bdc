// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "studies/scene/scene_builder.hpp"
#include <nlohmann/json.hpp>

namespace granum::cli {

/// A scene put together from defaults, a scene file and --set, for one command, as studies::SceneBuilder
/// takes them.
class SceneInput {
 public:
  SceneInput(studies::SceneCommand command, const studies::Scene& defaults)
      : builder_(command, defaults, "--set: ") {}

  /// \throws   FileError with path and line for unreadable text, an unknown key, an invalid value,
  ///           or a key that the command would ignore
  void read_file(const std::string& path);
  /// "key=value" of --set.
  /// \throws   InvalidArgument
  void set(const std::string& setting);

  /// The keys given so far, for options that set a key.
  [[nodiscard]] studies::Scene& scene() { return builder_.scene(); }

  /// The scene, checked as a whole.
  /// \throws   InvalidArgument, FileError
  [[nodiscard]] studies::Scene finished();

 private:
  studies::SceneBuilder builder_;
  std::string path_; ///< of the file
};

/// The complete scene stored by an earlier run of a command; it may contain keys without effect.
/// \throws   FileError, InvalidArgument
[[nodiscard]] studies::Scene read_scene(const std::string& path, studies::SceneCommand command);

/// The resolved scene in SI, for manifests.
[[nodiscard]] nlohmann::ordered_json json_of(const studies::Scene& scene);
/// The keys that a command takes, with meaning and range, for help.
[[nodiscard]] std::string key_help(studies::SceneCommand command);

} // namespace granum::cli
