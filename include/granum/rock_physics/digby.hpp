// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/rock_physics/sphere_packing.hpp>

namespace granum::rock_physics {

/// Equal spheres that were bonded over small discs before the pressure came. A number that is left out stays
/// NaN and is refused by name.
struct BondedPacking {
  double shear_modulus = SpherePacking::unset;       ///< G_g > 0 of the grain [Pa]
  double poisson_ratio = SpherePacking::unset;       ///< nu_g of the grain, -1 < nu_g <= 0.5
  double porosity = SpherePacking::unset;            ///< in [0, 1)
  double coordination_number = SpherePacking::unset; ///< C_n = 2 N_c/N >= 0
  double pressure = SpherePacking::unset;            ///< p >= 0, effective, compression positive [Pa]
  double bond_radius_ratio = SpherePacking::unset;   ///< radius of the bonds by that of the grains, in [0, 1)
};

/// Moduli of a bonded packing. Pressure widens the contact discs from b to a = sqrt(b^2 + d^2), d the real
/// root of d^3 + 3/2 b^2 d = 3 pi (1-nu_g) p/(2 C_n (1-phi) G_g), radii by grain radius; only the bond itself
/// resists sliding: K = C_n (1-phi) G_g a/(3 pi (1-nu_g)), G = 0.6 K (1 + 3 (1-nu_g)/(2-nu_g) b/a).
/// Without bonds it is the smooth packing of hertz_mindlin, without pressure a = b; 0 at C_n = 0.
///                                                                                               [Digby1981]
/// Assumes   contacts follow the mean strain.
/// \throws   InvalidArgument naming the first member that no packing can have
/// \return   moduli, with notes if C_n > 12 or if contacts exceed a tenth of the grain radius
/// Accuracy  8 ulp for p from 1e-300 to 1e12 Pa.  Checked by tests/rock_physics/test_digby.cpp
[[nodiscard]] IsotropicEstimate digby(const BondedPacking& packing);

} // namespace granum::rock_physics
