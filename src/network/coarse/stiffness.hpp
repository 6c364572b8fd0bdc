// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/network.
#pragma once

#include "factor.hpp"
#include "grid.hpp"
#include "network/backbone.hpp"

namespace granum::network {

/// P^T H P of the motions P of the nodes of a grid (coarse_correction.cpp), factorised.
template <int Dof>
[[nodiscard]] CoarseFactor coarse_stiffness(const Backbone& backbone, const CoarseGrid& grid,
                                            const Workers& workers);

} // namespace granum::network
