// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <granum/verify/scene.hpp>

namespace CLI {
class App;
} // namespace CLI

namespace granum::cli {

/// The options by which `verify` and `plan` name their scene.
struct StudyOptions {
  std::string scene_file;
  std::vector<std::string> settings;
  std::size_t grains = 0; ///< 0: as the scene says
  std::size_t seeds = 0;
  std::size_t threads = 0;
  bool grains_given = false;
  bool seeds_given = false;
  bool threads_given = false;
};

void add_study_options(CLI::App& command, StudyOptions& options);

/// The scene file or else `base`, then --set, then --grains, --seeds and --threads.
/// \throws   FileError, InvalidArgument
[[nodiscard]] verify::Scene resolve(const StudyOptions& options, const verify::Scene& base = {});

} // namespace granum::cli
