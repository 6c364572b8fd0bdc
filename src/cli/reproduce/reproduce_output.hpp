// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "studies/reproduce/experiment_html.hpp"
#include <nlohmann/json.hpp>

/// Files and printed output of `granum reproduce`.
namespace granum::cli {

/// Files and folders that write_results makes.
[[nodiscard]] std::span<const char* const> result_names();

[[nodiscard]] nlohmann::ordered_json manifest_of(const studies::Experiment& experiment,
                                                 const std::vector<studies::Verdict>& verdicts,
                                                 const studies::RunTime& time);

/// Tables, figures, report.html and manifest; replaces those of an earlier run.
/// \throws   FileError
void write_results(const std::filesystem::path& folder, const studies::Experiment& experiment,
                   const std::vector<studies::Verdict>& verdicts, const nlohmann::ordered_json& manifest,
                   const studies::RunTime& time);

/// Tables 2, 4 and 5 with the paper's values, and the verdicts, as text.
[[nodiscard]] std::string report_of(const studies::Experiment& experiment,
                                    const std::vector<studies::Verdict>& verdicts,
                                    const studies::RunTime& time);

} // namespace granum::cli
