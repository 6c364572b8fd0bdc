// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include <granum/analysis/measure.hpp>
#include <granum/io/imported_packing.hpp>

/// Contacts that the positions and radii of grains show by themselves.
/// Checked by tests/studies/test_overlaps.cpp
namespace granum::studies {

/// All pairs of overlapping spheres as contacts without forces, sorted by (i, j); in cells narrower than two
/// diameters a pair may occur with several images.
/// \param    periodic  which pairs of faces a pair may reach through
/// \throws   InvalidArgument for an assembly that require_valid rejects
/// Cost      O(N)
[[nodiscard]] std::vector<packing::Contact> overlapping_pairs(const packing::Assembly& assembly,
                                                              const std::array<bool, 3>& periodic);

/// A packing of grains alone with the contacts of overlapping spheres, and notes on them; any other as it is.
/// Normal forces follow from the given law and material, if any; tangential ones depend on the
/// history and stay unknown.
/// \throws   InvalidArgument for a material that the law refuses
[[nodiscard]] io::ImportedPacking with_overlap_contacts(io::ImportedPacking packing,
                                                        const analysis::Given& given);

} // namespace granum::studies
