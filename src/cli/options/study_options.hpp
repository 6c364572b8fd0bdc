// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <granum/core/error.hpp>
#include <granum/io/output_file.hpp>
#include <nlohmann/json.hpp>

#include "cli/frame/frame.hpp"
#include "cli/frame/option_row.hpp"
#include "studies/report/panel.hpp"
#include "studies/scene/scene_keys.hpp"
#include "studies/verify/findings.hpp"

namespace granum::cli {

/// The scene options of the commands of SceneCommand.
struct StudyOptions {
  std::string scene_file; ///< empty: not given
  std::vector<std::string> settings;
  std::optional<std::size_t> grains;
  std::optional<std::size_t> seeds;
  std::optional<std::size_t> threads;
};

void add_study_options(Command& command, StudyOptions& options, studies::SceneCommand of);

/// The options for the output of results.
struct ResultOptions {
  std::string out; ///< folder; empty: not given
  bool json = false;
  bool force = false;
  bool quiet = false;

  /// With only --json nothing is written.
  [[nodiscard]] bool writes_files() const { return !json || !out.empty(); }
  [[nodiscard]] io::Existing existing() const { return force ? io::Existing::replace : io::Existing::keep; }
  /// Prints the report, or the manifest with --json.
  void print(const std::string& report, const nlohmann::ordered_json& manifest) const;
};

/// \param    out_help, json_help   help of --out and --json
/// \param    replaced              the files that --force replaces, for its help
void add_result_options(Command& command, ResultOptions& options, const std::string& out_help,
                        const std::string& json_help = "Print one JSON object, SI units; writes files only "
                                                       "with --out",
                        const std::string& replaced = "existing results");

/// Adds --strict for a command without comparisons: it does not start if a key is probably a mistake.
void add_strict_scene(Command& command, bool& strict);

/// Reports on standard error, as a note, the cost of widely different grain sizes (studies::cost_of_sizes).
void say_cost_of_sizes(const studies::Scene& scene);
/// The JSON object with that note in "notes", if there is one.
[[nodiscard]] nlohmann::ordered_json with_cost_of_sizes(nlohmann::ordered_json json,
                                                        const studies::Scene& scene);

/// Reports values of a scene that are possible but probably mistakes, before the run.
/// \return   true if this ends the command, with exit code not_converged, under strict
[[nodiscard]] bool refuses(const Validity& slips, bool strict);

/// `base`, then the scene file, then --set, then --grains, --seeds and --threads.
/// \throws   FileError, InvalidArgument
[[nodiscard]] studies::Scene resolve(const StudyOptions& options, studies::SceneCommand command,
                                     const studies::Scene& base = {});

/// --strict of studies that compare with a paper.
void add_strict(Command& command, bool& strict);

/// Exit code of a finished study: fell_short if a check of granum failed or, under strict, if a result
/// differs from the paper; else ok. Writes each reason to standard error.
[[nodiscard]] ExitCode judged(const std::vector<studies::Verdict>& verdicts, bool strict);

/// Numbers and picture of each panel; replaces those of an earlier run.
/// \param    folder   created if missing
/// \throws   FileError
void write_panels(const std::filesystem::path& folder, const std::vector<studies::Panel>& panels);

} // namespace granum::cli
