// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/dem/specimen.hpp>
#include <granum/triaxial/specimen.hpp>

namespace granum::triaxial {

/// Grains of a recipe thrown into a cube one after the other, at random places where they touch none that is
/// there: a start for codes that make the packing themselves, of any number of grains.
/// Same recipe, same bits.
/// \param    solid_fraction   of the cube, in (0, 0.3]; beyond 0.38 no place is found any more [1]
/// \throws   InvalidArgument (recipe, solid fraction)
/// Cost      O(grains)
/// Checked by tests/triaxial/test_scatter.cpp
[[nodiscard]] dem::Specimen scattered_specimen(const SpecimenRecipe& recipe, double solid_fraction = 0.2);

} // namespace granum::triaxial
