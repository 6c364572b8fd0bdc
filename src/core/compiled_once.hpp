// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src. Compiled once: Boost's gamma functions and Eigen's solver of each size take seconds.
#pragma once

#include <cstddef>

#include <Eigen/Core>

namespace granum {

/// Gamma(z)/Gamma(z + 1/2), without the overflow of its parts.
[[nodiscard]] double gamma_ratio_half(double z);

/// Probability that chi-square of so many degrees of freedom is at least that large; 1 with no degree.
[[nodiscard]] double p_value(double chi_square, std::size_t degrees_of_freedom);

template <int Size>
struct SymmetricEigen {
  Eigen::Matrix<double, Size, 1> values;     ///< in increasing order
  Eigen::Matrix<double, Size, Size> vectors; ///< orthonormal columns, one of each value
};

/// Eigenvalues and eigenvectors of a symmetric matrix, by its lower triangle; of sizes 3 and 6.
template <int Size>
SymmetricEigen<Size> symmetric_eigen(const Eigen::Matrix<double, Size, Size>& symmetric);

} // namespace granum
