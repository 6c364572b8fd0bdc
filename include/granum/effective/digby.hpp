// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/effective/hertz_mindlin.hpp>

namespace granum::effective {

/// Moduli of spheres that are bonded over discs of radius b before the pressure acts:
/// K = C_n (1-porosity) S_n/(12 pi R), G = C_n (1-porosity)(S_n + 3/2 S_t)/(20 pi R) with
/// S_n = 4 G_g a/(1-nu_g), S_t = 8 G_g b/(2-nu_g); the contact radius a grows with the pressure from b on.
/// Assumes   uniform strain; the bond does not slip, the rest of the contact is smooth.           [Digby1981]
/// \param    bond_radius_ratio   b/R >= 0, small against 1
/// \return   exactly 0 for C_n = 0; at p = 0 the moduli of the bonds alone
/// \throws   InvalidArgument if a member is out of its range
/// Accuracy  12 ulp.  Checked by tests/effective/test_digby.cpp and validation/accuracy
[[nodiscard]] IsotropicModuli digby(const SpherePack& pack, double bond_radius_ratio);

} // namespace granum::effective
