// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "studies/analyse/force_chains.hpp"
#include "studies/analyse/frame_answer.hpp"
#include "studies/analyse/state_series.hpp"
#include <granum/io/csv/columns.hpp>
#include <granum/io/output_file.hpp>
#include <granum/io/packing_files.hpp>
#include <nlohmann/json.hpp>

/// Results of granum analyse, and their text.
namespace granum::cli {

using studies::find_rung;
using studies::FrameAnswer;
using studies::network_name;
using studies::RungResult;
using studies::RungSeries;
using studies::StateSeries;

struct AnalyseAnswer {
  std::vector<std::string> files;
  std::vector<io::FileKind> kinds;
  std::vector<FrameAnswer> frames;
  std::vector<StateSeries> series;                           ///< for more than one frame
  std::size_t skipped = 0;                                   ///< frames in one file only
  std::optional<studies::ForceChains> chains = std::nullopt; ///< of the last frame, if files are written
};

[[nodiscard]] nlohmann::ordered_json analyse_json(const AnalyseAnswer& answer);
[[nodiscard]] std::string analyse_table(const AnalyseAnswer& answer);

/// Names of the files that write_analysis writes.
inline constexpr const char* analysis_files[] = {"frames.csv",  "stiffness.csv", "rose.csv",   "forces.csv",
                                                 "rose.svg",    "forces.svg",    "chains.svg", "states.svg",
                                                 "report.html", "analysis.json"};
/// Writes tables of all frames, and a report and pictures of the last one.
/// \param    table   text of the terminal
/// \throws   FileError if a file cannot be written, or exists and is to be kept
void write_analysis(const std::filesystem::path& folder, const AnalyseAnswer& answer,
                    const std::string& table, io::Existing existing);

/// Whether a note of a reader reports missing data, as opposed to a problem in the data.
[[nodiscard]] bool says_what_is_missing(io::Finding finding);

} // namespace granum::cli
