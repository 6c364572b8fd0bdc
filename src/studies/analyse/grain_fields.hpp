// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <granum/io/grain_fields.hpp>
#include <granum/io/imported_packing.hpp>
#include <granum/network/linear_response.hpp>

namespace granum::studies {

/// Which forces of a packing are known. Unknown ones are not written: as zeros they would count as known.
[[nodiscard]] io::KnownForces known_forces(const io::ImportedPacking& packing);

/// io::grain_fields, and behind them the displacement beside a unit of each uniform strain, nonaffine_11 to
/// nonaffine_12 [m], of its body where grains form bodies; and D2min since another frame [m2].
/// \param    motions   of the network, or empty
/// \param    before    an earlier frame, or null
/// Checked by tests/studies/test_grain_fields.cpp
[[nodiscard]] std::vector<io::GrainField> grain_fields(const io::ImportedPacking& packing,
                                                       const network::StrainMotions& motions,
                                                       const io::ImportedPacking* before = nullptr);

} // namespace granum::studies
