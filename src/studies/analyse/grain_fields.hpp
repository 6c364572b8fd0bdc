// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <granum/io/grain_fields.hpp>
#include <granum/io/imported_packing.hpp>
#include <granum/network/linear_response.hpp>

namespace granum::studies {

/// Which forces of a packing are known. Unknown ones are not written: as zeros they would count as known.
[[nodiscard]] io::KnownForces known_forces(const io::ImportedPacking& packing);

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

/// io::grain_fields, and behind them the displacement beside a unit of each uniform strain, nonaffine_11 to
/// nonaffine_12 [m], of its body where grains form bodies; and D2min since another frame [m2].
/// \param    motions   of the network, or empty
/// \param    before    an earlier frame, or null
/// Checked by tests/studies/test_grain_fields.cpp
[[nodiscard]] std::vector<io::GrainField> grain_fields(const io::ImportedPacking& packing,
                                                       const network::StrainMotions& motions,
                                                       const io::ImportedPacking* before = nullptr);

} // namespace granum::studies
