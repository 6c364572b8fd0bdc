// SPDX-License-Identifier: GPL-3.0-or-later
// The stress printed by a code, compared with the stress from contacts.
#pragma once

#include <string>
#include <vector>

#include "analyse.hpp"

namespace granum::cli {

/// Assigns each frame its stress. `given` is the value of --stress: six stresses for each frame in their
/// order, or one name of a CSV file: columns xx, yy, zz, xy, xz, yz with units in their headings, one row a
/// frame in their order, or, where there is a column "step", the row of its time step. Nothing given: nothing
/// is compared.
/// \throws   InvalidArgument for other than one stress a frame; FileError for a file that is no such table,
///           or contains no row, or several, for a frame's step
void take_code_stress(const std::vector<std::string>& given, std::vector<FrameAnswer>& frames);

/// Adds a note where the stress by contacts and the code's own differ, relative to the largest component, as
/// shear stresses may be all but zero.
void judge_code_stress(const FrameAnswer& frame, Validity& out);

} // namespace granum::cli
