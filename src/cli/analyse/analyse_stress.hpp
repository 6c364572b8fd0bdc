// SPDX-License-Identifier: GPL-3.0-or-later
// What a code itself measured, beside what follows from its contacts: stresses, and moduli by probes.
#pragma once

#include <string>
#include <vector>

#include "analyse.hpp"

namespace granum::cli {

/// Gives each frame its stress. `given` is what stands behind --stress: six stresses for each frame in their
/// order, or one name of a CSV file: columns xx, yy, zz, xy, xz, yz with units in their headings, one row a
/// frame in their order, or, where there is a column "step", the row of its time step. Nothing given: nothing
/// is compared.
/// \throws   InvalidArgument for other than one stress a frame; FileError for a file that is no such table,
///           or holds no row, or several, of a frame's step
void take_code_stress(const std::vector<std::string>& given, std::vector<FrameAnswer>& frames);

/// Adds a note where the stress by contacts and the code's own differ, relative to the largest component, as
/// shear stresses may be all but zero.
void judge_code_stress(const FrameAnswer& frame, Validity& out);

/// Gives each frame the moduli that the code's own probes found. The file has a row a modulus, with columns
/// modulus (K, G, G_hh, G_vh, C11, C33, C12, C13) and value with its unit, as moduli.csv of an exported deck.
/// A column step, or a column state, a part of the names of the frame's files between points, assigns rows to
/// frames; without either there is one frame. An empty path: nothing is compared.
/// \throws   FileError for a file that is no such table, or a row that belongs to no frame
void take_probes(const std::string& path, std::vector<FrameAnswer>& frames);

} // namespace granum::cli
