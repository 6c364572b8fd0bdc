// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "studies/analyse/force_chains.hpp"
#include "studies/analyse/frame_series.hpp"
#include "studies/analyse/measured_frame.hpp"
#include <granum/effective/rungs.hpp>
#include <granum/io/csv/columns.hpp>
#include <granum/io/output_file.hpp>
#include <granum/io/packing_files.hpp>
#include <nlohmann/json.hpp>

/// What granum analyse works out, frame by frame, and how it is put into words.
namespace granum::cli {

/// A stress as a code prints it, compression positive: xx yy zz xy xz yz [Pa].
using PrintedStress = std::array<double, 6>;
inline constexpr const char* stress_names[] = {"xx", "yy", "zz", "xy", "xz", "yz"};

/// The components of a stress by contacts that codes print: sum d_a f_b over the volume, d the line of
/// centres, without making it symmetric.
[[nodiscard]] PrintedStress printed(const packing::ContactStress& stress);

/// Moduli of a stiffness, for the side-by-side table [Pa].
struct Moduli {
  double K = 0;
  double G = 0; ///< of the nearest isotropic stiffness
  double G_hh = 0;
  double G_vh = 0;
  double C11 = 0;
  double C33 = 0;
  double C12 = 0;
  double C13 = 0;
};
[[nodiscard]] Moduli moduli_of(const elastic::TransverselyIsotropic& stiffness);
[[nodiscard]] Moduli moduli_of(const elastic::VoigtStiffness& stiffness);

/// What one rung says of a frame, or why it cannot.
struct RungResult {
  std::string name;  ///< in JSON and headings
  std::string title; ///< in tables
  std::optional<Moduli> moduli = std::nullopt;
  std::optional<effective::ModulusErrors> relative_error = std::nullopt;
  std::string error = {};
};

/// What is measured: the frozen network, every grain in equilibrium.
inline constexpr const char* network_name = "rung4";

/// A count as a cell of a table takes it.
inline double number(std::size_t count) { return static_cast<double>(count); }

struct FrameAnswer {
  std::size_t number = 0;                ///< of the frame in the files, from 0
  std::string file = {};                 ///< of its grains
  std::vector<io::ImportNote> read = {}; ///< what the reader noted
  studies::MeasuredFrame measured = {};
  std::vector<RungResult> rungs = {}; ///< rungs 0 to 3, uniform stress, affine network, network
  std::optional<PrintedStress> code_stress = std::nullopt;
  std::optional<analysis::Window> window = std::nullopt; ///< of measured.packing.interior
  Validity validity = {};                                ///< of the closed forms
  double seconds = 0;                                    ///< reading left out
};

/// What a rung says of a frame; null if it says nothing.
[[nodiscard]] const RungResult* find_rung(const FrameAnswer& frame, const std::string& name);

/// The moduli that the network itself has, if they were found.
[[nodiscard]] const Moduli* network_moduli(const FrameAnswer& frame);

/// How the moduli of one rung grow over the frames of a series.
struct RungSeries {
  std::string name;
  std::string title;
  studies::SeriesFit fit;              ///< G over the mean stress
  std::optional<hardin::Fit> separate; ///< G_vh over sigma_v and sigma_h, where their ratio varies
};

/// States that belong together: of one packing, or of packings that were made alike.
struct StateSeries {
  std::string name;
  std::vector<std::size_t> frames; ///< places in the list of frames
  std::vector<RungSeries> rungs;
};

struct AnalyseAnswer {
  std::vector<std::string> files;
  std::vector<io::FileKind> kinds;
  std::vector<FrameAnswer> frames;
  std::vector<StateSeries> series;                           ///< for more than one frame
  std::size_t skipped = 0;                                   ///< frames that stand in one file only
  std::optional<studies::ForceChains> chains = std::nullopt; ///< of the last frame, if files are written
};

/// The columns of the table of frames, from which frames.csv and the screen are written.
[[nodiscard]] io::Columns<FrameAnswer> frame_columns(const AnalyseAnswer& answer);

[[nodiscard]] nlohmann::ordered_json analyse_json(const AnalyseAnswer& answer);
[[nodiscard]] std::string analyse_table(const AnalyseAnswer& answer);

/// Names of the files that write_analysis writes.
inline constexpr const char* analysis_files[] = {"frames.csv",  "stiffness.csv", "rose.csv",   "forces.csv",
                                                 "rose.svg",    "forces.svg",    "chains.svg", "states.svg",
                                                 "report.html", "analysis.json"};
/// Writes tables of all frames, and a report and pictures of the last one.
/// \param    table   what the screen shows
/// \throws   FileError if a file cannot be written, or exists and is to be kept
void write_analysis(const std::filesystem::path& folder, const AnalyseAnswer& answer,
                    const std::string& table, io::Existing existing);

/// Whether a note of a reader says what the files could not tell, not what was found in them.
[[nodiscard]] bool says_what_is_missing(io::Finding finding);

} // namespace granum::cli
