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

#include "cli/document/document.hpp"

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
  std::string cut = {};                                      ///< why the last frame is missing, if it is
  std::optional<studies::ForceChains> chains = std::nullopt; ///< of the last frame, if files are written
};

/// Everything that was measured: the last frame, or two of them, with all values, and a line for each frame;
/// charts of the last one.
[[nodiscard]] Document analysed(const AnalyseAnswer& answer);

// ---- charts (analyse_charts.cpp)

/// Directions of contacts of a frame with a fabric, as a rose diagram with E(gamma; a).
[[nodiscard]] plot::Chart rose_chart(const FrameAnswer& frame);
/// Distribution of the normal forces of a frame with forces.
[[nodiscard]] plot::Chart force_chart(const FrameAnswer& frame);
/// G of each rung with its stated error, compared with that of the network.
[[nodiscard]] plot::Chart rung_chart(const FrameAnswer& frame);
/// G and K over p with both axes logarithmic, then z*, C_n and e over p, with points for each series of the
/// answer. Empty unless the mean stress varies by a tenth.
[[nodiscard]] std::vector<Picture> state_pictures(const AnalyseAnswer& answer);
/// The rung whose G these show: the network, else rung 3.
[[nodiscard]] const RungSeries* shown_rung(const StateSeries& series);
/// "336 MPa".
[[nodiscard]] std::string megapascal(double pascal);

/// Names of the files that write_analysis writes.
inline constexpr const char* analysis_files[] = {"frames.csv", "stiffness.csv", "rose.csv",     "forces.csv",
                                                 "rose.svg",   "forces.svg",    "chains.svg",   "states.svg",
                                                 "modes.csv",  "report.html",   "analysis.json"};
/// Writes tables of all frames, and a report and pictures of the last one.
/// \throws   FileError if a file cannot be written, or exists and is to be kept
void write_analysis(const std::filesystem::path& folder, const AnalyseAnswer& answer,
                    const Document& document, io::Existing existing);

/// The stiffness matrix of a packing's network in MatrixMarket format, with the ids of its grains as
/// comments.
/// \throws   InvalidArgument as studies::stiffened
[[nodiscard]] std::string stiffness_file(const io::ImportedPacking& packing,
                                         const studies::MeasureOptions& options);

/// Whether a note of a reader reports missing data, as opposed to a problem in the data.
[[nodiscard]] bool says_what_is_missing(io::Finding finding);

} // namespace granum::cli
