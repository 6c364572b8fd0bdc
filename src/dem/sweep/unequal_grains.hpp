// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/dem. What the sweeps know of grains of different sizes.
#pragma once

#include <vector>

#include <granum/dem/specimen.hpp>

#include "grain_rows.hpp"

namespace granum::dem {

/// What is each grain's own; nothing where all are equal.
/// \param    density   of the grains [kg/m^3]; all their masses together are density times volume, and are
///                     shared out as engine.hpp says
[[nodiscard]] std::vector<OwnSize> own_sizes(const Specimen& state, double density);

/// The same for a minimiser, whose masses are numbers that it may choose: the contacts of a grain, and so the
/// stiffness that holds it, grow with its surface, so its mass is the square of its size over the mean size,
/// and 1 where that is less. With unit masses the largest are held far more stiffly than the rest: 2,000
/// grains of C_u = 3 were not at rest after 200,000 steps, where with these some 60,000 do.
/// Checked by tests/dem/test_grain_motion.cpp and tests/triaxial/test_specimen.cpp
[[nodiscard]] std::vector<OwnSize> sizes_for_descent(const Specimen& state);

} // namespace granum::dem
