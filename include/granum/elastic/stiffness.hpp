// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <granum/core/vec3.hpp>

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

/// \file
/// Eigenvalues and eigenvectors of a symmetric 6 x 6 matrix.
/// Checked by tests/elastic/test_eigen_system.cpp

struct EigenSystem {
  Eigen::Matrix<double, 6, 1> values; ///< ascending
  Matrix6 vectors;                    ///< orthonormal columns, in the order of the values
};

/// \param    symmetric  of finite entries; only its lower triangle is read
/// Accuracy  1e-14 of the largest magnitude of an eigenvalue.
[[nodiscard]] EigenSystem eigen_system(const Matrix6& symmetric);

/// \file
/// Operations on the orthonormal (Mandel) basis: change of basis, rotation, definiteness, distance.
/// Functions of a full stiffness refuse one that is not symmetric: |C_ab - C_ba| above 1e-3 of the largest
/// entry. Solvers leave less than 1e-6, and two halves printed with four digits, each rounded by itself,
/// differ by 1e-3 at most; up to there the symmetric part is used. A matrix in which one half was
/// left out is far above.
/// Checked by tests/elastic/test_mandel.cpp

/// Voigt to Mandel: shear rows and columns times sqrt 2. [Mehrabadi1990]
[[nodiscard]] MandelStiffness mandel(const VoigtStiffness& stiffness);
/// Mandel to Voigt, the inverse of the above.
[[nodiscard]] VoigtStiffness voigt(const MandelStiffness& stiffness);

/// Orthogonal 6 x 6 matrix that turns a symmetric tensor in Mandel form as R turns its axes: mandel(R t R^T).
/// \param    rotation  proper rotation: R^T R = 1 within 1e-10, det R = 1
/// \throws   InvalidArgument for any other matrix
/// Accuracy  4 ulp of 1.
[[nodiscard]] Matrix6 mandel_rotation(const Mat3& rotation);
/// The stiffness of the material after it was turned by `rotation`, in unchanged axes.
/// \throws   InvalidArgument as mandel_rotation, and for a stiffness that is not symmetric or not finite
[[nodiscard]] MandelStiffness rotate(const MandelStiffness& stiffness, const Mat3& rotation);
[[nodiscard]] VoigtStiffness rotate(const VoigtStiffness& stiffness, const Mat3& rotation);

/// Smallest eigenvalue over its largest magnitude [1]: in [-1, 1], 0 for a zero matrix.
/// \throws   InvalidArgument for a stiffness that is not symmetric or not finite
/// Accuracy  1e-15 absolute.
[[nodiscard]] double relative_smallest_eigenvalue(const MandelStiffness& stiffness);
/// relative_smallest_eigenvalue above `tolerance`, a number above the rounding of whatever made the matrix.
[[nodiscard]] bool positive_definite(const MandelStiffness& stiffness, double tolerance = 1e-12);
/// relative_smallest_eigenvalue not below -`tolerance`.
[[nodiscard]] bool positive_semidefinite(const MandelStiffness& stiffness, double tolerance = 1e-12);

/// |C - C^T|/|C| in the Frobenius norm [1]; 0 for a zero matrix.
[[nodiscard]] double symmetry_residual(const MandelStiffness& stiffness);
/// |a - b|/|a| in the Frobenius norm, which no rotation changes [1]; 0 if both are zero.
/// \throws   InvalidArgument if a is zero and b is not
[[nodiscard]] double relative_distance(const MandelStiffness& a, const MandelStiffness& b);

/// \file
/// How far a stiffness is from the classes of symmetry: pure numbers, so that soil in Pa and quartz in GPa
/// are treated alike. The caller decides which distance still counts as symmetric: rounding is 1e-15, a
/// measured or simulated stiffness carries its own error.
/// Checked by tests/elastic/test_symmetry.cpp

/// |C - P(C)|/|C| in the Mandel norm, in [0, 1], with P(C) the nearest stiffness of the class. [Moakher2006]
/// The classes lie within one another: isotropic >= transversely_isotropic >= orthotropic and isotropic >=
/// cubic >= orthotropic, but for rounding.
struct SymmetryDistances {
  double isotropic = 0;              ///< the same for every choice of axes
  double cubic = 0;                  ///< cube edges along the coordinate axes
  double transversely_isotropic = 0; ///< axis of symmetry 3
  double orthotropic = 0;            ///< planes of symmetry across the coordinate axes
};

/// \throws   InvalidArgument if the stiffness is zero, not symmetric or not finite
/// Accuracy  1e-15 absolute.
[[nodiscard]] SymmetryDistances symmetry_distances(const VoigtStiffness& stiffness);

} // namespace granum::elastic
