// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "studies/report/panel.hpp"
#include "studies/verify/findings.hpp"
#include <granum/io/output_file.hpp>

#include "cli/document/document.hpp"
#include "cli/options/study_options.hpp"

/// What `granum verify` found, as a document and files.  Checked by tests/cli/test_verify_document.cpp
namespace granum::cli {

/// Whether every specimen was run to its end.
[[nodiscard]] bool complete(const std::vector<studies::SpecimenResult>& specimens);

/// The results of a study as objects of JSON, from which all that is printed of it is made: again, if asked.
/// \param    options   as given, for their scene file and settings
/// \param    slips     of the scene, which are warned of
[[nodiscard]] nlohmann::ordered_json results_of(const studies::Scene& scene,
                                                const std::vector<studies::SpecimenResult>& specimens,
                                                const std::vector<studies::Verdict>& verdicts, double seconds,
                                                const StudyOptions& options, const Validity& slips);

/// The document of such results, and the panels of its pictures.
struct StudyDocument {
  Document document;
  std::vector<studies::Panel> panels;
};
/// \throws   nlohmann::json::exception if these are no results of verify
[[nodiscard]] StudyDocument study_document(const studies::Scene& scene,
                                           const nlohmann::ordered_json& results);

/// Agreements with the paper, differences from it, and checks of granum itself, with how many agree.
[[nodiscard]] Table verdict_table(const std::vector<studies::Verdict>& verdicts);

/// Every key of a scene, as it was used.
[[nodiscard]] Items scene_items(const studies::Scene& scene);
/// Adds the note on the cost of widely different grain sizes (studies::cost_of_sizes), if there is one.
void add_cost_of_sizes(Document& to, const studies::Scene& scene);

/// Files and folders that write_results makes.
[[nodiscard]] std::span<const char* const> study_file_names();
/// Tables, scene, manifest, page and figures.
/// \throws   FileError if a file cannot be written, or exists and may not be replaced
void write_results(const std::filesystem::path& folder, const studies::Scene& scene,
                   const StudyDocument& study, const nlohmann::ordered_json& manifest, io::Existing existing);
/// Reads scene and manifest of a finished run, and writes its page and figures again.
/// \throws   FileError if one of them is missing or damaged
void rewrite_page(const std::filesystem::path& folder);

} // namespace granum::cli
