// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/elastic/transverse_isotropic.hpp>

/// Effect of water in the pores on stiffness and mass.
namespace granum::elastic {

/// Of water of 20 degrees Celsius [kg/m3].                                                   [Mavko2009]
inline constexpr double water_density = 998;

/// Properties of grains and pores for Gassmann's relation.
struct SaturatedPores {
  double grain_bulk_modulus = 0; ///< K_s of the grains' solid [Pa], > 0
  double fluid_bulk_modulus = 0; ///< K_f of the pore fluid [Pa], > 0
  double void_ratio = 0;         ///< e [1], > 0
};

/// Bulk modulus of water and air mixed finely, 1/(S/K_w + (1 - S)/K_a): that of air but for the last per
/// cent. Water of 20 degrees Celsius, 2.18 GPa; air at one atmosphere, 0.142 MPa.            [Mavko2009]
/// Assumes   one pressure in both; the forces of menisci between grains are not in it.
/// \param    saturation   S, share of the pores' volume that is water, in [0, 1]
/// \throws   InvalidArgument outside of that range
/// Accuracy  2 ulp.  Checked by tests/elastic/test_saturation.cpp
[[nodiscard]] double water_and_air_bulk_modulus(double saturation);

/// Share of the pores that must be water for a packing to have that mass,
/// S = ((1+e) rho - rho_s)/(e rho_w).
/// \param    bulk_density    rho of grains and water together, > 0 [kg/m3]
/// \param    grain_density   rho_s of the grains' solid, > 0 [kg/m3]
/// \param    void_ratio      e > 0 [1]
/// \return   outside of [0, 1] where no such packing has that mass
/// \throws   InvalidArgument outside of these ranges
/// Accuracy  8 ulp of rho_s/(e rho_w).  Checked by tests/elastic/test_saturation.cpp
[[nodiscard]] double saturation_of_bulk_density(double bulk_density, double grain_density, double void_ratio);

/// Undrained stiffness of a skeleton whose pores are filled: C_ij + a_i a_j M for the normal components,
/// a_i = 1 - (C_i1 + C_i2 + C_i3)/(3 K_s), 1/M = (1 - K/K_s - n)/K_s + n/K_f with n = e/(1+e) and K the mean
/// of all normal components. Shear moduli stay. Isotropic: K_sat of the usual equation.
/// [Gassmann1951; Mavko2009]
/// Assumes   one solid, connected pores, frequencies at which the fluid moves with the grains.
/// \param    skeleton   dry, or drained [Pa]
/// \throws   InvalidArgument for pores out of their ranges, and for a skeleton stiffer than its grains
/// Accuracy  4 ulp of C33.  Checked by tests/elastic/test_saturation.cpp
[[nodiscard]] TransverselyIsotropic saturated(const TransverselyIsotropic& skeleton,
                                              const SaturatedPores& pores);

} // namespace granum::elastic
