// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <granum/io/imported_packing.hpp>

namespace granum::studies {

/// Centre distance over R_i + R_j below which two grains are neighbours, unless another is given [1].
inline constexpr double neighbour_reach = 1.5;

/// analysis::d2min between two frames of a packing, with the neighbours before of centres closer than
/// reach (R_i + R_j); grains are the same if their ids are.
/// \param    reach   in [1, 5]
/// \return   one for each grain of the frame after [m2]; 0 for one that is not in both
/// \throws   InvalidArgument for a reach out of range
/// Checked by tests/studies/test_grain_fields.cpp
[[nodiscard]] std::vector<double> d2min(const io::ImportedPacking& before, const io::ImportedPacking& after,
                                        double reach = neighbour_reach);

} // namespace granum::studies
