// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <granum/verify/scene_keys.hpp>

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

void add_study_options(CLI::App& app, StudyOptions& options, verify::SceneCommand command);

/// `base`, then the scene file, then --set, then --grains, --seeds and --threads.
/// \throws   FileError, InvalidArgument
[[nodiscard]] verify::Scene resolve(const StudyOptions& options, verify::SceneCommand command,
                                    const verify::Scene& base = {});

} // namespace granum::cli
