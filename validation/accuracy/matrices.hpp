// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include <granum/core/vec3.hpp>
#include <granum/elastic/stiffness.hpp>
#include <granum/elastic/transverse_isotropic.hpp>

#include "harness.hpp"

/// Tensors of rank four as 6 x 6 matrices, in 50-digit arithmetic.
namespace accuracy {

template <std::size_t n>
struct Square {
  Real entries[n][n];

  Real* operator[](int row) { return entries[row]; }
  const Real* operator[](int row) const { return entries[row]; }
};
using Real3 = Square<3>;
using Real6 = Square<6>;

/// A well conditioned stiffness, C33, C12 and C13 of the size of C11.
granum::elastic::TransverselyIsotropic draw_stiffness(Draw& draw);
/// A positive definite matrix without symmetry but its own: diagonally dominant.
granum::elastic::VoigtStiffness draw_full_stiffness(Draw& draw);
granum::Vec3 draw_direction(Draw& draw);
/// A rotation to double precision.
granum::Mat3 draw_rotation(Draw& draw);

/// Voigt index of the pair ij.
int voigt_index(int i, int j);
/// Entries with the shear rows and columns times sqrt 2: the Mandel form of a Voigt stiffness.
Real6 mandel_of(const granum::elastic::VoigtStiffness& c);
Real6 voigt_of(const granum::elastic::TransverselyIsotropic& c);

/// C'_ijkl = R_ia R_jb R_kc R_ld C_abcd of a Voigt stiffness, as a Voigt stiffness.
Real6 turned(const Real6& voigt, const Real3& R);
/// Largest magnitude of an entry.
Real largest(const Real6& m);

/// Eigenvalues of a symmetric matrix, ascending, by Jacobi's rotations.
std::array<Real, 3> eigenvalues(Real3 m);

} // namespace accuracy
