// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/elastic/stiffness.hpp>

/// The moduli of a full stiffness along the axes and in their planes, whatever its symmetry.
/// Checked by tests/elastic/test_engineering_moduli.cpp
namespace granum::elastic {

/// Seven moduli that a test on a cube with its edges along the axes would find [Pa]. Nothing is averaged over
/// directions: a stiffness that is not symmetric about axis 3 shows it.
struct EngineeringModuli {
  double bulk_modulus = 0; ///< K: mean stress over volumetric strain when all three axes are strained alike
  double E_1 = 0;          ///< axial stress over axial strain along axis 1, no other stress changing
  double E_2 = 0;
  double E_3 = 0;
  double C44 = 0; ///< shear stress over engineering shear in the plane 23, no other strain changing
  double C55 = 0; ///< in the plane 13
  double C66 = 0; ///< in the plane 12
};

/// Assumes   a positive semidefinite matrix, but for rounding.
/// \return   E = 0 along an axis where the packing gives way without stress
/// \throws   InvalidArgument for a stiffness that is not symmetric (mandel.hpp) or not finite
/// Accuracy  1e-14 of the largest entry, E times the condition number of the matrix.
[[nodiscard]] EngineeringModuli engineering_moduli(const VoigtStiffness& stiffness);

} // namespace granum::elastic
