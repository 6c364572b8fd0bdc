// SPDX-License-Identifier: GPL-3.0-or-later
// The answer for a sand: measured laws, supplemented by mechanics.
#pragma once

#include <cstddef>

#include <granum/elastic/transverse_isotropic.hpp>
#include <granum/estimate/answer.hpp>

namespace granum::estimate {

inline double& at(Values& values, Field field) { return values[static_cast<std::size_t>(field)]; }

/// estimate::answer of grain_shape sand.
/// Assumes   a question validated by answer()
Answer sand_answer(const Question& question, std::span<const Spread> spreads);

/// Fills in the densities and wave speeds of a stiffness.
/// Assumes   that the density of the grains is known
void set_speeds(Values& all, const Question& question, const elastic::TransverselyIsotropic& stiffness);

/// \throws   InvalidArgument if a number exceeds the range of a double
void require_finite_values(const Values& all);

} // namespace granum::estimate
