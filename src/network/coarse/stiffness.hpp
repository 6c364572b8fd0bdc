// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/network.
#pragma once

#include "factor.hpp"
#include "grid.hpp"
#include "network/backbone.hpp"

namespace granum::network {

/// Factor of P^T H P for the motions P of the nodes of a grid (coarse/correction.cpp).
template <int Dof>
[[nodiscard]] CoarseFactor coarse_stiffness(const Backbone& backbone, const CoarseGrid& grid,
                                            const Workers& workers);

} // namespace granum::network
