// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/contact/power_law.hpp>
#include <granum/effective/state.hpp>
#include <granum/elastic/transverse_isotropic.hpp>

/// Sphere packs that were strained evenly and then uniaxially: stress-induced anisotropy.
namespace granum::effective {

/// The order in which the two strains were applied. Tangential forces remember it, the stiffness does not.
enum class StrainPath {
  hydrostatic_first, ///< then the uniaxial strain
  uniaxial_first,    ///< then the hydrostatic strain
  together           ///< both in proportion
};

/// A random packing of equal spheres under a hydrostatic strain plus a vertical one.
struct StrainedPack {
  contact::GrainMaterial grain;              ///< of the spheres
  double porosity = State::unset;            ///< voids in the volume, in (0, 1)
  double coordination_number = State::unset; ///< C_n >= 0, over all grains
  double hydrostatic_strain = State::unset;  ///< along each axis, compression positive, >= 0
  double uniaxial_strain = State::unset;     ///< along the axis on top of it, compression positive, >= 0
  double no_slip_share = 1;                  ///< contacts with Mindlin's tangential stiffness, in [0, 1]
};

/// Stiffness of the strained packing under uniform strain: contacts of stiffness k_n ~ (e0 + e3 n3^2)^(1/2),
/// isotropic in direction, integrated in closed form or, where that would cancel, by quadrature.
///                                                                      [NorrisJohnson1997; Walton1987]
/// Assumes   all grains follow the mean strain and touch already at zero strain; no slip of rough contacts.
/// \return   exactly 0 for zero strain
/// \throws   InvalidArgument if a member is out of its range
/// Accuracy  relative 1e-14.  Checked by tests/effective/test_norris_johnson.cpp
[[nodiscard]] elastic::TransverselyIsotropic norris_johnson(const StrainedPack& pack);

/// Principal stresses, compression positive.
struct AxisymmetricStress {
  double vertical = 0;   ///< [Pa]
  double horizontal = 0; ///< in both directions [Pa]
};

/// Stress that holds the strained packing, after that path.                              [NorrisJohnson1997]
/// \throws   InvalidArgument if a member is out of its range
/// Accuracy  relative 1e-14 of the vertical stress.  Checked by tests/effective/test_norris_johnson.cpp
[[nodiscard]] AxisymmetricStress norris_johnson_stress(const StrainedPack& pack, StrainPath path);

} // namespace granum::effective
