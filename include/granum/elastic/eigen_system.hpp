// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/elastic/stiffness.hpp>

/// Eigenvalues and eigenvectors of a symmetric 6 x 6 matrix.
/// Checked by tests/elastic/test_eigen_system.cpp
namespace granum::elastic {

struct EigenSystem {
  Eigen::Matrix<double, 6, 1> values; ///< ascending
  Matrix6 vectors;                    ///< orthonormal columns, in the order of the values
};

/// \param    symmetric  of finite entries; only its lower triangle is read
/// Accuracy  1e-14 of the largest magnitude of an eigenvalue.
[[nodiscard]] EigenSystem eigen_system(const Matrix6& symmetric);

} // namespace granum::elastic
