// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "studies/analyse/frame_answer.hpp"
#include "studies/analyse/materials.hpp"
#include "studies/analyse/measured_frame.hpp"
#include "studies/analyse/window.hpp"
#include <granum/io/packing_files.hpp>

#include "analyse.hpp"
#include "cli/options/input_options.hpp"

/// The command line of granum analyse.
namespace granum::cli {

struct AnalyseOptions {
  std::vector<std::string> files;
  InputValues inputs; ///< contact law and grains
  std::string adhesion, rolling_stiffness, twisting_stiffness;
  Number friction_angle{0, Dimension::angle};
  std::string column_map;
  std::string box;
  std::string units; ///< si, or empty
  std::string axis = "z";
  std::string frames = "all";
  std::string series = "name";     ///< or all
  std::vector<std::string> stress; ///< one per frame, or the name of a file with them
  std::string probes;              ///< name of a file of moduli
  std::string stiffness_from;
  std::vector<std::string> materials; ///< one per type
  std::optional<std::size_t> threads;
  std::string window = "auto";
  std::string depth;
  std::string profile; ///< "z:20"; empty for none
  bool no_network = false;
  bool json = false;
  bool strict = false;
  bool force = false;
  bool paraview = false;
  bool xyz = false;
  std::optional<std::size_t> modes;
  std::string hessian; ///< file; empty for none
  std::string out;     ///< folder; empty for none
};

void add_analyse_options(Command& command, AnalyseOptions& options);

/// The selected frames.
struct FrameChoice {
  std::size_t first = 0;
  std::size_t last = std::numeric_limits<std::size_t>::max();
  std::size_t stride = 1;
  bool only_last = false; ///< of the files

  [[nodiscard]] bool takes(std::size_t number) const {
    return number >= first && number <= last && (number - first) % stride == 0;
  }
};

// Texts of options as values, empty for an empty text.
// \throws InvalidArgument for other text, a range without a frame, and options that contradict each other

/// "all", "last", "3", "2:10", "2:", "0:100:10".
[[nodiscard]] FrameChoice parse_frames(const std::string& text);
/// "4mm,4mm,4mm": a periodic box.
[[nodiscard]] std::optional<io::CsvBox> parse_box(const std::string& text);
/// "49kPa,50kPa,51kPa,-0.3kPa,0.4kPa,-0.3kPa".
[[nodiscard]] studies::PrintedStress parse_stress(const std::string& text);
/// "x0..x1,y0..y1,z0..z1", each end a length or empty, and "d0..d1" below the top.
[[nodiscard]] std::optional<studies::WindowChoice> parse_window(const std::string& window,
                                                                const std::string& depth);
/// "z:20".
[[nodiscard]] std::optional<studies::ProfileChoice> parse_profile(const std::string& text);
/// "1:shear-modulus=30GPa,poisson-ratio=0.15", once for each type.
[[nodiscard]] studies::MaterialsByType parse_materials(const std::vector<std::string>& texts);
/// "2e4N/m", "1e-3Nm", "0.1" or "marshall".
[[nodiscard]] std::optional<packing::TurningSpring> parse_turning(const std::string& name,
                                                                  const std::string& text);
/// "jkr:0.05J/m2".
[[nodiscard]] std::optional<contact::Adhesion> parse_adhesion(const std::string& text);
[[nodiscard]] studies::MeasureOptions measure_options(const AnalyseOptions& options);

} // namespace granum::cli
