// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include <granum/core/vec3.hpp>
#include <granum/elastic/stiffness.hpp>
#include <granum/elastic/transverse_isotropic.hpp>

/// Plane waves: Gamma_ik = C_ijkl n_j n_l has density v^2 as eigenvalues and the directions in which the
/// material moves as eigenvectors.                                                           [Musgrave1970]
/// Assumes   small amplitude, wave length far above the grain size, stiffness of the undamped packing.
/// A direction is any vector but zero; its length does not matter. The three polarisations are orthonormal
/// for every direction, also where two or three speeds coincide (the axis of symmetry, isotropic solids), and
/// the fastest points along the direction rather than against it.
/// Checked by tests/elastic/test_christoffel.cpp
namespace granum::elastic {

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
///           (mandel.hpp) and positive semidefinite (smallest eigenvalue above -1e-12 of the largest)
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

} // namespace granum::elastic
