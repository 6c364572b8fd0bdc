// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "studies/verify/findings.hpp"
#include "studies/verify/local_exponents.hpp"
#include "studies/verify/study.hpp"
#include <granum/io/output_file.hpp>
#include <nlohmann/json.hpp>

/// Files and printed output of `granum verify`.
namespace granum::cli {

/// A finished study with its results.
struct StudyOutcome {
  studies::Scene scene;
  std::vector<studies::SpecimenResult> specimens;
  std::vector<studies::ExponentRow> exponents;
  std::vector<studies::LocalExponents> local_exponents; ///< for laws with a force scale
  std::vector<studies::Verdict> verdicts;
  double seconds = 0;
  bool stopped = false; ///< on request

  [[nodiscard]] bool complete() const;
};

/// Files and folders that write_results makes.
[[nodiscard]] std::span<const char* const> study_file_names();

/// \param    scene_file, settings   as given by the options
[[nodiscard]] nlohmann::ordered_json manifest_of(const StudyOutcome& outcome, const std::string& scene_file,
                                                 const std::vector<std::string>& settings);

/// Tables, scene, manifest, report.html and its figures.
/// \throws   FileError if a file cannot be written, or exists and may not be replaced
void write_results(const std::filesystem::path& folder, const StudyOutcome& outcome,
                   const nlohmann::ordered_json& manifest, io::Existing existing);

/// Reads scene and manifest of a finished run, and writes its report.html and figures again.
/// \throws   FileError if one of them is missing or damaged
void rewrite_report(const std::filesystem::path& folder);

/// States, exponents and verdicts as text.
[[nodiscard]] std::string report_of(const StudyOutcome& outcome);

} // namespace granum::cli
