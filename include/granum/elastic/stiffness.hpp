// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

/// Full 6 x 6 elastic stiffness in its two matrix forms. Compression positive; index order 11 22 33 23 13 12.
namespace granum::elastic {

using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Voigt form: stress (11 22 33 23 13 12) = matrix * strain with engineering shears
/// (2 e23, 2 e13, 2 e12) [Pa].
struct VoigtStiffness {
  Matrix6 matrix = Matrix6::Zero();
};

/// Mandel form: the same tensor on an orthonormal basis (shear rows and columns carry sqrt 2), so that
/// eigenvalues, norms and rotations of the matrix are those of the tensor [Pa].
struct MandelStiffness {
  Matrix6 matrix = Matrix6::Zero();
};

} // namespace granum::elastic
