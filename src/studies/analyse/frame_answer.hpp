// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "studies/analyse/materials.hpp"
#include "studies/analyse/measured_frame.hpp"
#include "studies/analyse/window.hpp"
#include <granum/analysis/profile.hpp>
#include <granum/effective/rungs.hpp>
#include <granum/elastic/stiffness.hpp>
#include <granum/elastic/transverse_isotropic.hpp>
#include <granum/network/lowest_modes.hpp>

/// One frame with all rungs of the ladder beside each other.
/// Checked by tests/studies/test_frame_answer.cpp
namespace granum::studies {

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
/// Of the nearest stiffness that is symmetric about axis 3.
[[nodiscard]] Moduli moduli_of(const elastic::VoigtStiffness& stiffness);

/// Result of one rung for a frame, or the reason why there is none.
struct RungResult {
  std::string name;  ///< in JSON and headings
  std::string title; ///< in tables
  std::optional<Moduli> moduli = std::nullopt;
  /// Moduli of one axis have a meaning; not under a stress that is not symmetric about it, where K and G of
  /// the nearest isotropic stiffness and the 6x6 of the network are what there is.
  bool one_axis = true;
  std::optional<effective::ModulusErrors> relative_error = std::nullopt;
  std::string error = {};
  std::optional<double> network_over_K = std::nullopt; ///< K of the network over that of the rung
  std::optional<double> network_over_G = std::nullopt;
};

/// A modulus that a code's own probe found, small cycles of strain of a state [Pa].
struct ProbedModulus {
  std::string modulus; ///< K, G, G_vh, G_hh, or C11 to C66
  double value = 0;
  std::optional<double> network_over_probe = std::nullopt;
};
/// The measured stiffness: the frozen network, every grain in equilibrium.
[[nodiscard]] std::string network_name();
/// Rung 3 in the list of a frame's rungs.
[[nodiscard]] std::string relaxed_name();

struct FrameAnswer {
  std::size_t number = 0;                ///< of the frame in the files, from 0
  std::string file = {};                 ///< of its grains
  std::vector<io::ImportNote> read = {}; ///< notes of the reader
  MeasuredFrame measured = {};
  std::vector<RungResult> rungs = {}; ///< rungs 0 to 3, uniform stress, affine network, network
  std::optional<PrintedStress> code_stress = std::nullopt;
  std::vector<ProbedModulus> probes = {}; ///< by the code itself
  std::vector<network::Mode> modes = {};  ///< of the network, from the lowest frequency on, if requested
  std::optional<analysis::Window> window = std::nullopt; ///< of measured.packing.interior
  std::vector<analysis::Slice> profile = {};             ///< where one is asked for
  int profile_axis = 2;
  Validity validity = {}; ///< of the closed forms
  double seconds = 0;     ///< reading left out
};

/// Slices across an axis of the results.
struct ProfileChoice {
  int axis = 2;
  std::size_t slices = 1;
};

/// Given properties of the packings, and the requested measurements.
struct MeasureOptions {
  analysis::Given given;
  analysis::Wanted wanted;
  MaterialsByType materials = {};
  std::optional<WindowChoice> window = {};
  std::optional<ProfileChoice> profile = {}; ///< of the window that is given, or of the whole packing
  std::size_t modes = 0;                     ///< lowest modes of the network; they need given.grain_density
  bool choose_window = true;                 ///< use interior_window, if there is one and no other is given
};

/// Measures a frame and evaluates every rung for it.
/// \throws   InvalidArgument as measure_frame, materials_of and window_in
[[nodiscard]] FrameAnswer answer_frame(const io::ImportedPacking& packing, const MeasureOptions& options);

/// Result of a rung for a frame; null if there is none.
[[nodiscard]] const RungResult* find_rung(const FrameAnswer& frame, const std::string& name);

/// The mean stress of the state of the closed forms [Pa]; empty without forces.
[[nodiscard]] std::optional<double> mean_stress(const FrameAnswer& frame);
/// The mean of the stress that the code printed [Pa].
[[nodiscard]] std::optional<double> mean_code_stress(const FrameAnswer& frame);

/// The stress by contacts over the code's own, less 1, by component; empty if the latter is 0.
[[nodiscard]] std::array<std::optional<double>, 6> stress_differences(const FrameAnswer& frame);
/// The largest difference of a component over the largest component of the code's own stress; nothing unless
/// both stresses are known.
[[nodiscard]] std::optional<double> largest_stress_difference(const FrameAnswer& frame);

/// G of the network over that of rung 3.
[[nodiscard]] std::optional<double> network_over_relaxed(const FrameAnswer& frame);

} // namespace granum::studies
