// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/effective/uniform_field.hpp>
#include <granum/stress/stress.hpp>

namespace granum::rock_physics {

/// Equal spheres compressed by the mean strain e0 in all directions plus e3 along axis 3. A number that is
/// left out stays NaN and is refused by name.
struct StrainedPacking {
  double shear_modulus = effective::State::unset;       ///< G_g > 0 of the grain [Pa]
  double poisson_ratio = effective::State::unset;       ///< nu_g of the grain, -1 < nu_g <= 0.5
  double porosity = effective::State::unset;            ///< in [0, 1)
  double coordination_number = effective::State::unset; ///< C_n = 2 N_c/N >= 0
  double hydrostatic_strain = effective::State::unset;  ///< e0 in [0, 1), compression positive
  double uniaxial_strain = effective::State::unset;     ///< e3 in [0, 1), compression positive, on top of e0
  double no_slip_fraction = 1;                          ///< share of no-slip contacts in [0, 1]
};

/// In which order the two strains were applied. Tangential forces remember it; the stiffness does not.
enum class StrainPath { hydrostatic_first, uniaxial_first, simultaneous };

/// Transversely isotropic stiffness of the strained packing: contacts follow the mean strain, so that a
/// contact at n3 = x carries k_n ~ sqrt(e0 + e3 x^2). Exactly isotropic at e3 = 0, Walton's uniaxial state at
/// e0 = 0, zero without strain.                                           [NorrisJohnson1997; Walton1987]
/// Assumes   no fabric, no sliding of no-slip contacts, isotropic distribution of contacts.
/// \throws   InvalidArgument naming the first member that no packing can have
/// \return   stiffness, with notes if C_n > 12 or if contacts exceed a tenth of the grain radius
/// Accuracy  relative 4e-15, C12 and C13 of C11, for any e0/e3.
/// Checked by tests/rock_physics/test_norris_johnson.cpp
[[nodiscard]] effective::Estimate norris_johnson(const StrainedPacking& packing);

/// Stresses of the packing at these strains when they were applied along the path; no-slip contacts
/// keep the tangential forces that they gathered on the way.                             [NorrisJohnson1997]
/// Assumes   as norris_johnson; no contact slides on the path.
/// \throws   InvalidArgument as norris_johnson
/// Accuracy  relative 1e-14 of the vertical stress.  Checked by tests/rock_physics/test_norris_johnson.cpp
[[nodiscard]] stress::AxialStress norris_johnson_stress(const StrainedPacking& packing, StrainPath path);

} // namespace granum::rock_physics
