// SPDX-License-Identifier: GPL-3.0-or-later
// Alone in this source, because Eigen's solver takes long to compile.
#include <granum/elastic/eigen_system.hpp>

#include <Eigen/Eigenvalues>

namespace granum::elastic {

EigenSystem eigen_system(const Matrix6& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Matrix6> solver(symmetric);
  return {.values = solver.eigenvalues(), .vectors = solver.eigenvectors()};
}

} // namespace granum::elastic
