// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <granum/analysis/measure.hpp>
#include <granum/io/csv/packing.hpp>
#include <granum/io/imported_packing.hpp>

/// One measured frame of another code's output, as printed by `granum analyse`.
/// Checked by tests/studies/test_measured_frame.cpp
namespace granum::studies {

struct MeasuredFrame {
  long step = 0;
  std::optional<double> time = {}; ///< [s]
  bool materials_given = false;    ///< of each grain
  bool adhesion_given = false;     ///< so that contacts may pull
  bool contacts_known = true;      ///< otherwise C_n, z* and rattlers of `packing` are invalid
  bool triaxial = false;           ///< the stress is not symmetric about axis 3
  analysis::Measurement packing = {};
  std::vector<std::string> warnings = {}; ///< one sentence each
};

/// Measures an imported packing.
/// Assumes   axis 3 is vertical, the axis of symmetry of the closed forms.
/// \param    given   properties that files do not contain and a user may know; those of forces and digits
///           that the reader found take precedence
/// \throws   InvalidArgument for values given or wanted that are out of their ranges
[[nodiscard]] MeasuredFrame measure_frame(const io::ImportedPacking& packing, analysis::Given given = {},
                                          const analysis::Wanted& wanted = analysis::everything());

/// The same for a table of contacts without grains: directions, and forces where the table has them.
/// \throws   InvalidArgument for values given or wanted that are out of their ranges
[[nodiscard]] MeasuredFrame measure_frame(const io::ContactTable& table, analysis::Given given = {},
                                          const analysis::Wanted& wanted = analysis::everything());

/// The assembly whose network measure_frame solves.
/// \throws   InvalidArgument as analysis::stiffened
[[nodiscard]] packing::Assembly stiffened(const io::ImportedPacking& packing, const analysis::Given& given);

} // namespace granum::studies
