// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/rock_physics/sphere_packing.hpp>

namespace granum::rock_physics {

/// Moduli of a random packing of equal spheres under uniform strain, without fabric:
/// K = [C_n^2 (1-phi)^2 G_g^2 p/(18 pi^2 (1-nu_g)^2)]^(1/3) and G = K 3 (2 + 3 r)/10, where
/// r = no_slip_fraction 2(1-nu_g)/(2-nu_g) is the mean k_t/k_n. Exactly 0 at p = 0 and at C_n = 0.
///                                                                              [Mindlin1949; Walton1987]
/// Assumes   contacts follow the mean strain: an upper bound, far above the truth in loose packings.
/// \throws   InvalidArgument as require_valid(SpherePacking)
/// Accuracy  8 ulp for p from 1e-300 to 1e12 Pa.  Checked by tests/rock_physics/test_hertz_mindlin.cpp
[[nodiscard]] IsotropicEstimate hertz_mindlin(const SpherePacking& packing);

} // namespace granum::rock_physics
