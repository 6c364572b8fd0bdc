// SPDX-License-Identifier: GPL-3.0-or-later
#include "compiled_once.hpp"

#include <Eigen/Eigenvalues>
#include <boost/math/special_functions/gamma.hpp>

namespace granum {

double gamma_ratio_half(double z) { return boost::math::tgamma_delta_ratio(z, 0.5); }

double p_value(double chi_square, std::size_t degrees_of_freedom) {
  return degrees_of_freedom > 0
             ? boost::math::gamma_q(static_cast<double>(degrees_of_freedom) / 2, chi_square / 2)
             : 1;
}

template <int Size>
SymmetricEigen<Size> symmetric_eigen(const Eigen::Matrix<double, Size, Size>& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, Size, Size>> solver(symmetric);
  return {.values = solver.eigenvalues(), .vectors = solver.eigenvectors()};
}

template SymmetricEigen<3> symmetric_eigen(const Eigen::Matrix<double, 3, 3>&);
template SymmetricEigen<6> symmetric_eigen(const Eigen::Matrix<double, 6, 6>&);

} // namespace granum
