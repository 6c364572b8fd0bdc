// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src. Compiled once, because Eigen's solver takes seconds to compile for each size.
#pragma once

#include <Eigen/Core>

namespace granum {

template <int Size>
struct SymmetricEigen {
  Eigen::Matrix<double, Size, 1> values;     ///< in increasing order
  Eigen::Matrix<double, Size, Size> vectors; ///< orthonormal columns, one of each value
};

/// Eigenvalues and eigenvectors of a symmetric matrix, by its lower triangle; of sizes 3 and 6.
template <int Size>
SymmetricEigen<Size> symmetric_eigen(const Eigen::Matrix<double, Size, Size>& symmetric);

} // namespace granum
