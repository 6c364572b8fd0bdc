// SPDX-License-Identifier: GPL-3.0-or-later
// Stresses and probed moduli reported by a code, compared with those that follow from its contacts.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <granum/elastic/stiffness.hpp>

#include "analyse.hpp"

namespace granum::cli {

/// Assigns each frame its stress. `given` is the value of --stress: six stresses for each frame in their
/// order, or one name of a CSV file: columns xx, yy, zz, xy, xz, yz with units in their headings, one row per
/// frame in their order, or, with a column "step", the row of its time step. Without a value nothing is
/// compared.
/// \throws   InvalidArgument for other than one stress per frame; FileError for a file that is no such table,
///           or contains no row, or several, for a frame's step
void take_code_stress(const std::vector<std::string>& given, std::vector<FrameAnswer>& frames);

/// Adds a note if the stress computed from contacts and that reported by the code differ, relative to the
/// largest component, because shear stresses may be nearly zero.
void judge_code_stress(const FrameAnswer& frame, Validity& out);

/// A modulus that a probe measures, and its value for a stiffness in the axes of the file [Pa].
struct Probing {
  const char* name;
  double (*of)(const elastic::VoigtStiffness&);
};
/// All that a table of probes may name.
[[nodiscard]] std::span<const Probing> probings();

/// Gives each frame the moduli probed by the code. The file has one row per modulus, with columns modulus and
/// value with its unit, as moduli.csv of an exported deck. Moduli are K and G, of the nearest isotropic
/// stiffness, and components of the 6x6 in the axes of the file: G_vh = C55 (z and x), G_hh = C66 (x and y),
/// C11, C22, C33, C12, C13, C23, C44, C55, C66.
/// Rows are assigned to frames by a column step or a column state (a part of the names of the frame's files
/// between points); without either there is one frame. With an empty path nothing is compared.
/// \throws   FileError for a file that is no such table, or a row that belongs to no frame
void take_probes(const std::string& path, std::vector<FrameAnswer>& frames);

} // namespace granum::cli
