// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/dem. Data of unequal grains for the sweeps.
#pragma once

#include <vector>

#include <granum/dem/specimen.hpp>

#include "grain_rows.hpp"

namespace granum::dem {

/// Data of each grain; empty if all are equal.
/// \param    density   of the grains [kg/m^3]; the total mass is density times volume, divided as described
///           in engine.hpp
[[nodiscard]] std::vector<OwnSize> own_sizes(const Specimen& state, double density);

/// The same for a minimiser, whose masses are free. The number of contacts of a grain, and so the stiffness
/// that acts on it, grows with its surface; its mass is therefore the square of its size over the mean size,
/// and at least 1. With unit masses 2,000 grains of C_u = 3 were not at rest after 200,000 steps; with these
/// masses they need some 60,000.
/// Checked by tests/dem/test_grain_motion.cpp and tests/triaxial/test_specimen.cpp
[[nodiscard]] std::vector<OwnSize> sizes_for_descent(const Specimen& state);

} // namespace granum::dem
