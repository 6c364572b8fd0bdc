// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/rock_physics/norris_johnson.hpp>

namespace granum::rock_physics {

/// Equal spheres compressed along axis 3 only, from the state in which they just touch.
struct UniaxialPacking {
  double shear_modulus = effective::State::unset;       ///< G_g > 0 of the grain [Pa]
  double poisson_ratio = effective::State::unset;       ///< nu_g of the grain, -1 < nu_g <= 0.5
  double porosity = effective::State::unset;            ///< in [0, 1)
  double coordination_number = effective::State::unset; ///< C_n = 2 N_c/N >= 0
  double uniaxial_strain = effective::State::unset;     ///< e3 in [0, 1), compression positive
  double no_slip_fraction = 1; ///< share of no-slip contacts in [0, 1]: 1 rough, 0 smooth
};

/// Stiffness after uniaxial compression. With M = 3 C_n (1-phi) G_g sqrt(e3)/(pi (1-nu_g)) and r the mean
/// k_t/k_n: C11 = M (1+r)/16, C33 = M (2+r)/12, C12 = M (1-r)/48, C13 = M (1-r)/24, C44 = M (4+5r)/96.
/// The C44 that is often reprinted is M (2+7r)/96, against the average over the contacts.        [Walton1987]
/// Assumes   as norris_johnson, of which this is the limit e0 = 0.
/// \throws   InvalidArgument naming the first member that no packing can have
/// Accuracy  8 ulp.  Checked by tests/rock_physics/test_walton_uniaxial.cpp
[[nodiscard]] effective::Estimate walton_uniaxial(const UniaxialPacking& packing);

/// Its stresses; the ratio horizontal/vertical is nu_g/(4 (3 - 2 nu_g)) for rough grains and 1/4
/// for smooth ones.                                                                           [Walton1987]
/// \throws   InvalidArgument as walton_uniaxial
/// Accuracy  8 ulp.  Checked by tests/rock_physics/test_walton_uniaxial.cpp
[[nodiscard]] stress::AxialStress walton_uniaxial_stress(const UniaxialPacking& packing);

} // namespace granum::rock_physics
