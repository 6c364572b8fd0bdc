// SPDX-License-Identifier: GPL-3.0-or-later
// The answer of a sand: what was measured, with mechanics beside.
#pragma once

#include <cstddef>

#include <granum/elastic/transverse_isotropic.hpp>
#include <granum/estimate/answer.hpp>

namespace granum::estimate {

inline double& at(Values& values, Field field) { return values[static_cast<std::size_t>(field)]; }

/// estimate::answer of grain_shape sand.
/// Assumes   a question that answer() has found valid
Answer sand_answer(const Question& question, std::span<const Spread> spreads);

/// Densities and wave speeds of a stiffness, at their places.
/// Assumes   that the density of the grains is known
void set_speeds(Values& all, const Question& question, const elastic::TransverselyIsotropic& stiffness);

/// \throws   InvalidArgument if a number is beyond what a double holds
void require_finite_values(const Values& all);

} // namespace granum::estimate
