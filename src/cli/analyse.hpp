// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <granum/io/packing_files.hpp>
#include <granum/verify/analysis.hpp>
#include <nlohmann/json.hpp>

#include "rungs.hpp"

/// What granum analyse works out, frame by frame, and how it is put into words.
namespace granum::cli {

/// A stress as a code prints it, compression positive: xx yy zz xy xz yz [Pa].
using PrintedStress = std::array<double, 6>;
inline constexpr const char* stress_names[] = {"xx", "yy", "zz", "xy", "xz", "yz"};

/// The components of a stress by contacts that codes print: sum d_a f_b over the volume, d the line of
/// centres, without making it symmetric.
[[nodiscard]] PrintedStress printed(const ContactStress& stress);

/// What one closed form says of a frame, or why it cannot.
struct ClosedForm {
  const Rung* rung = nullptr;
  std::optional<FieldAnswer> answer = {};
  std::string error = {};
};

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

struct FrameAnswer {
  std::size_t number = 0;                ///< of the frame in the files, from 0
  std::vector<io::ImportNote> read = {}; ///< what the reader noted
  verify::Analysis analysis = {};
  std::vector<ClosedForm> closed = {};
  std::optional<PrintedStress> code_stress = {};
  double seconds = 0; ///< reading left out
};

struct AnalyseAnswer {
  std::vector<std::string> files = {};
  std::vector<io::FileKind> kinds = {};
  std::vector<FrameAnswer> frames = {};
  std::size_t skipped = 0; ///< frames that stand in one file only
};

[[nodiscard]] nlohmann::ordered_json analyse_json(const AnalyseAnswer& answer);
[[nodiscard]] std::string analyse_table(const AnalyseAnswer& answer);

/// Whether a note of a reader says what the files could not tell, not what was found in them.
[[nodiscard]] bool says_what_is_missing(io::Finding finding);

} // namespace granum::cli
