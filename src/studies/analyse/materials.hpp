// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include <granum/contact/power_law.hpp>
#include <granum/io/imported_packing.hpp>

namespace granum::studies {

/// Materials of grains by their type in the files.
using MaterialsByType = std::map<long, contact::GrainMaterial>;

/// The material of each grain.
/// \return   none for no materials
/// \throws   InvalidArgument if the files contain no types, or for a type without material
/// Checked by tests/studies/test_materials.cpp
[[nodiscard]] std::vector<contact::GrainMaterial> materials_of(const io::ImportedPacking& packing,
                                                               const MaterialsByType& materials);

} // namespace granum::studies
