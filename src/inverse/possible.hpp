// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/inverse/inference.hpp>

namespace granum::inverse::detail {

/// Refuses measurements at one state that no stable solid has together: a compression wave whose modulus is
/// smaller than 4/3 of a shear modulus or than a bulk modulus, by more than three standard errors.
/// Assumes   dry or drained, as require_measured checks before
/// \param    grain_density   to compare speeds with moduli [kg/m3]
/// \throws   InvalidArgument naming the compression wave
/// Checked by tests/inverse/test_inference.cpp, test_sand_inference.cpp
void require_possible_together(std::span<const Observation> all, std::optional<double> grain_density);

/// Refuses a fitted exponent of growth with stress that the measurements do not determine, or that is outside
/// of [0, 1] by more than two standard errors: a forecast by it would be no forecast.
/// \param    limit   largest standard error
/// \throws   InvalidArgument
void require_determined_growth(const Measured& exponent, double limit);

} // namespace granum::inverse::detail
