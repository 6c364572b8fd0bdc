// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/dem. What the sweeps know of grains of different sizes.
#pragma once

#include <vector>

#include <granum/dem/specimen.hpp>

#include "grain_rows.hpp"

namespace granum::dem {

/// What is each grain's own; nothing where all are equal.
/// \param    density   of the grains [kg/m^3]; all their masses together are density times volume, and
/// are shared                     out as engine.hpp says
[[nodiscard]] std::vector<OwnSize> own_sizes(const Specimen& state, double density);

} // namespace granum::dem
