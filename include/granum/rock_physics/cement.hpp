// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/rock_physics/sphere_packs.hpp>

namespace granum::rock_physics {

/// A packing of equal spheres, just touching, whose pores are partly filled with cement. A number that is
/// left out stays NaN and is refused by name.
struct CementedPacking {
  double shear_modulus = SpherePacking::unset;        ///< G_g > 0 of the grain [Pa]
  double poisson_ratio = SpherePacking::unset;        ///< nu_g of the grain, -1 < nu_g <= 0.5
  double cement_shear_modulus = SpherePacking::unset; ///< G_c > 0 [Pa]
  double cement_poisson_ratio = SpherePacking::unset; ///< -1 < nu_c < 0.5
  double porosity = SpherePacking::unset;             ///< before cementation (critical), in [0, 1)
  double coordination_number = SpherePacking::unset;  ///< C_n = 2 N_c/N >= 0
  double cement_saturation = SpherePacking::unset;    ///< share of those pores that is cement, in [0, 1]
};

/// Where the cement sits.
enum class CementScheme {
  at_contacts,   ///< all of it in discs around the contacts (scheme 1)
  surface_layer, ///< evenly on the surface of the grains (scheme 2)
};

/// S = (critical - porosity)/critical, the cement_saturation that leaves this porosity.
/// \throws   InvalidArgument unless 0 <= porosity <= critical_porosity < 1 and critical_porosity > 0
/// Accuracy  2 ulp.  Checked by tests/rock_physics/test_contact_cement.cpp
[[nodiscard]] double cement_saturation(double critical_porosity, double porosity);

/// Radius of the cement disc by grain radius: 2 [S phi/(3 C_n (1-phi))]^(1/4) at contacts,
/// [2 S phi/(3 (1-phi))]^(1/2) in a surface layer.                                         [DvorkinNur1996]
/// \throws   InvalidArgument naming the first member that no packing can have, and for C_n = 0 at contacts
/// Accuracy  4 ulp.  Checked by tests/rock_physics/test_contact_cement.cpp
[[nodiscard]] double cement_radius_ratio(const CementedPacking& packing, CementScheme scheme);

/// Moduli of the cemented packing by the published regression of its contact stiffness:
/// K = C_n (1-phi) M_c S_n/6, G = 0.6 K + 3 C_n (1-phi) G_c S_t/20, M_c = K_c + 4/3 G_c. The regression is
/// that of [DvorkinNur1996], the integral equation that it represents is that of [DvorkinNur1994].
/// Assumes   contacts follow the mean strain; no pressure on the cement's contacts.
/// \throws   InvalidArgument as cement_radius_ratio, and where the regression turns negative
/// \return   moduli, with notes where the regression differs from the integral equation that it represents by
///           more than a tenth: disc radius outside [0.05, 1] grain radii, or cement too soft or too stiff
///           against the grain; and where a modulus exceeds the average of grain, cement and pore, an upper
///           bound
/// Accuracy  16 ulp of the regression, which itself is within 12 % of the integral equation where nothing is
///           noted.  Checked by tests/rock_physics/test_contact_cement.cpp
[[nodiscard]] IsotropicEstimate contact_cement(const CementedPacking& packing, CementScheme scheme);

/// \file
/// Sands between a packing of clean spheres at its critical porosity and the solid mineral at porosity 0, by
/// modified Hashin-Shtrikman bounds: the packing has the volume fraction porosity/critical porosity.

/// The lower bound: pore-filling fines, sorting. The packing surrounds the mineral.       [DvorkinNur1996]
/// \param    packing    end member by hertz_mindlin; its porosity > 0 is the critical one
/// \param    porosity   in [0, critical porosity]
/// \return   K and G [Pa]: at porosity 0 those of the mineral (K infinite for nu_g = 0.5), at the critical
///           porosity those of the packing, both exactly; 0 at p = 0 in between
/// \throws   InvalidArgument as require_valid(SpherePacking), and for a porosity out of its range
/// Accuracy  8 ulp.  Checked by tests/rock_physics/test_sand_bounds.cpp
[[nodiscard]] IsotropicEstimate soft_sand(const SpherePacking& packing, double porosity);

/// The upper bound: contacts stiffened by the mineral, which surrounds the packing.              [Gal1998]
/// Parameters, result and errors as soft_sand, but not 0 at p = 0.
/// Accuracy  8 ulp.  Checked by tests/rock_physics/test_sand_bounds.cpp
[[nodiscard]] IsotropicEstimate stiff_sand(const SpherePacking& packing, double porosity);

} // namespace granum::rock_physics
