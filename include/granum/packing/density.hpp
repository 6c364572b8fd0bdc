// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/packing/assembly.hpp>

namespace granum::packing {

/// Volume of the grains over that of the cell, (1/V) sum (4/3) pi R^3.
/// Assumes   spheres, of one radius or many; the small lenses shared by overlapping grains count twice.
/// \return   solid fraction [1]; 0 without grains
/// \throws   InvalidArgument for an assembly that require_valid rejects
/// Checked by tests/packing/test_density.cpp
[[nodiscard]] double solid_fraction(const Assembly& assembly);

/// e = V/(sum (4/3) pi R^3) - 1 [1]; assumptions of solid_fraction.
/// \throws   InvalidArgument also for an assembly without grains: the ratio has no value
/// Checked by tests/packing/test_density.cpp
[[nodiscard]] double void_ratio(const Assembly& assembly);

} // namespace granum::packing
