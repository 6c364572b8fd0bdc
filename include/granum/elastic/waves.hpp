// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include <granum/core/vec3.hpp>
#include <granum/elastic/isotropic.hpp>
#include <granum/elastic/stiffness.hpp>
#include <granum/elastic/transverse_isotropic.hpp>

/// Density of a packing, water in its pores, and the speeds of plane waves in an isotropic one.
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

/// \file
/// Plane waves: Gamma_ik = C_ijkl n_j n_l has density v^2 as eigenvalues and the directions in which the
/// material moves as eigenvectors.                                                           [Musgrave1970]
/// Assumes   small amplitude, wave length far above the grain size, stiffness of the undamped packing.
/// A direction is any vector but zero; its length does not matter. The three polarisations are orthonormal
/// for every direction, also where two or three speeds coincide (the axis of symmetry, isotropic solids), and
/// the fastest points along the direction rather than against it.
/// Checked by tests/elastic/test_christoffel.cpp

struct PlaneWave {
  double speed = 0; ///< phase speed v [m/s]
  Vec3 polarisation{};
};

/// The three waves along one direction of any material.
struct PlaneWaves {
  PlaneWave fastest;
  PlaneWave middle;
  PlaneWave slowest;
};

/// The three waves of a transversely isotropic material, by their kind.
struct TransverselyIsotropicWaves {
  PlaneWave quasi_p; ///< in the plane of direction and axis
  PlaneWave quasi_s; ///< in that plane, never faster than quasi_p; V_SV of vertical propagation
  PlaneWave pure_s;  ///< horizontal, perpendicular to that plane: SH
};

/// Waves of a full stiffness.
/// \param    bulk_density   mass per volume of the packing [kg/m3], > 0
/// \param    direction      of propagation
/// \throws   InvalidArgument for another density or direction, or unless the stiffness is finite, symmetric
///           (stiffness.hpp) and positive semidefinite (smallest eigenvalue above -1e-12 of the largest)
/// Accuracy  v^2 to 1e-14 of the largest v^2, polarisations orthonormal to 4e-15.
[[nodiscard]] PlaneWaves plane_waves(const VoigtStiffness& stiffness, double bulk_density,
                                     const Vec3& direction);

/// Waves of a full stiffness along the axes 1, 2 and 3.
/// \throws   InvalidArgument as above
/// Accuracy  as above.  Checked by tests/elastic/test_engineering_moduli.cpp
[[nodiscard]] std::array<PlaneWaves, 3> plane_waves_along_axes(const VoigtStiffness& stiffness,
                                                               double bulk_density);

/// Waves of a transversely isotropic stiffness in closed form. Along the axis, where the plane of direction
/// and axis is any vertical plane, axis 1 is assumed to lie in it.
/// \throws   InvalidArgument as above
/// Accuracy  4 ulp each speed, a slow quasi_s too, unless C11 C33 - C13^2 is far below C44 C33.
[[nodiscard]] TransverselyIsotropicWaves plane_waves(const TransverselyIsotropic& stiffness,
                                                     double bulk_density, const Vec3& direction);

/// Velocity of energy, C_ijkl p_i p_k n_l/(density v) [m/s]; its part along the direction is the phase speed.
/// \param    wave   one of plane_waves(stiffness, bulk_density, direction), which must move: speed > 0
/// Where two speeds coincide it belongs to the given polarisation, not to the direction.
/// \throws   InvalidArgument for a density not positive, a zero direction, a wave without speed, or a
///           stiffness as above
/// Accuracy  1e-14 of the largest speed times that speed over v.
[[nodiscard]] Vec3 group_velocity(const VoigtStiffness& stiffness, double bulk_density, const Vec3& direction,
                                  const PlaneWave& wave);

/// \file
/// Transverse isotropy in the seismologist's notation: two speeds along the axis and three pure numbers, all
/// zero for an isotropic solid.                                               [Thomsen1986, Eqs 8a, 8b, 17]
/// Checked by tests/elastic/test_thomsen.cpp

struct ThomsenParameters {
  double epsilon = 0; ///< (C11-C33)/(2 C33)
  double delta = 0;   ///< exact or weak, according to the function that made it
  double gamma = 0;   ///< (C66-C44)/(2 C44)

  bool operator==(const ThomsenParameters&) const = default;
};

/// A solid by its density, its speeds along the axis and its exact parameters.
struct ThomsenSolid {
  double bulk_density = 0;     ///< [kg/m3]
  double vertical_p_speed = 0; ///< V_p0, sqrt(C33/density) [m/s]
  double vertical_s_speed = 0; ///< V_s0, sqrt(C44/density) [m/s]
  ThomsenParameters anisotropy{};

  bool operator==(const ThomsenSolid&) const = default;
};

/// Exact parameters: delta = ((C13+C44)^2 - (C33-C44)^2)/(2 C33 (C33-C44)), half the curvature of
/// ln V_p at the axis.                                                                [Thomsen1986, Eq. 17]
/// \throws   InvalidArgument unless the stiffness is positive definite and C33 > C44
/// Accuracy  8 ulp; near isotropy too, where the factors of delta are formed without cancellation.
[[nodiscard]] ThomsenParameters thomsen_parameters(const TransverselyIsotropic& stiffness);

/// The same with delta to first order in the anisotropy, (C13 + 2 C44 - C33)/C33.       [Mensch1997, Eq. 20]
/// \throws   InvalidArgument unless the stiffness is positive definite
/// Accuracy  4 ulp.
[[nodiscard]] ThomsenParameters weak_thomsen_parameters(const TransverselyIsotropic& stiffness);

/// Speeds along the axis and exact parameters of a stiffness.
/// \param    bulk_density   mass per volume of the packing [kg/m3], > 0
/// \throws   InvalidArgument as thomsen_parameters, or for another density
/// Accuracy  8 ulp.
[[nodiscard]] ThomsenSolid thomsen_solid(const TransverselyIsotropic& stiffness, double bulk_density);

/// Stiffness of a solid given by exact parameters: the inverse of thomsen_solid.
/// Assumes   C13 + C44 >= 0. A solid with C13 + C44 < 0 shares its delta with one that has the opposite sum.
/// \param    solid   density > 0, V_p0 > V_s0 > 0
/// \throws   InvalidArgument for other speeds, or if no positive definite stiffness has these parameters
/// Accuracy  8 ulp of C33.
[[nodiscard]] TransverselyIsotropic transversely_isotropic(const ThomsenSolid& solid);

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
