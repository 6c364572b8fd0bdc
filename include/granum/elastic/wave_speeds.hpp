// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/elastic/isotropic.hpp>

/// Density of a packing, and the speeds of plane waves in an isotropic one.
/// Checked by tests/elastic/test_wave_speeds.cpp
namespace granum::elastic {

/// Components of a packing's mass.
struct GrainsAndPores {
  double grain_density = 0; ///< of the grains' solid, rho_s [kg/m3], > 0
  double void_ratio = 0;    ///< e [1], >= 0
  double pore_density = 0;  ///< of the pore fluid [kg/m3], >= 0; 0: dry
};

/// Mass per volume of the packing, (rho_s + e rho_pore)/(1+e) [kg/m3].
/// \throws   InvalidArgument outside the ranges named above
/// Accuracy  3 ulp.
[[nodiscard]] double bulk_density(const GrainsAndPores& packing);

/// Speeds of plane waves [m/s]; they do not depend on the direction.
struct WaveSpeeds {
  double p = 0; ///< compression wave, V_p = sqrt((K + 4G/3)/density)
  double s = 0; ///< shear wave, V_s = sqrt(G/density)

  bool operator==(const WaveSpeeds&) const = default;
};

/// Speeds in an isotropic solid. Moduli of the dry skeleton with a dry density: no pore pressure is modelled.
/// \param    bulk_density   mass per volume of the packing [kg/m3], > 0
/// \throws   InvalidArgument for another density, or for the incompressible limit K = inf
/// Accuracy  2 ulp.
[[nodiscard]] WaveSpeeds wave_speeds(const Isotropic& solid, double bulk_density);

/// G = density V_s^2 [Pa].
/// \param    shear_wave_speed   V_s [m/s], >= 0
/// \param    bulk_density       [kg/m3], > 0
/// \throws   InvalidArgument outside these ranges
/// Accuracy  1 ulp.
[[nodiscard]] double shear_modulus_from_speed(double shear_wave_speed, double bulk_density);

/// The isotropic solid that has these speeds, G = density V_s^2, K = density (V_p^2 - 4 V_s^2/3).
/// \throws   InvalidArgument unless density > 0 [kg/m3], V_s > 0 and V_p > sqrt(4/3) V_s, so that K > 0
/// Accuracy  4 ulp times V_p^2 density/K.
[[nodiscard]] Isotropic isotropic_from_speeds(const WaveSpeeds& speeds, double bulk_density);

} // namespace granum::elastic
