// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "studies/scene/scene_keys.hpp"

namespace CLI {
class App;
} // namespace CLI

namespace granum::cli {

/// The options by which the commands of SceneCommand name their scene.
struct StudyOptions {
  std::string scene_file; ///< empty: not given
  std::vector<std::string> settings;
  std::optional<std::size_t> grains;
  std::optional<std::size_t> seeds;
  std::optional<std::size_t> threads;
};

void add_study_options(CLI::App& app, StudyOptions& options, studies::SceneCommand command);

/// `base`, then the scene file, then --set, then --grains, --seeds and --threads.
/// \throws   FileError, InvalidArgument
[[nodiscard]] studies::Scene resolve(const StudyOptions& options, studies::SceneCommand command,
                                     const studies::Scene& base = {});

} // namespace granum::cli
