// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/elastic/stiffness.hpp>

#include "samples.hpp"
#include "unit.hpp"

using namespace granum::elastic;

TEST_CASE("eigenvalues that are known, in ascending order, on turned axes") {
  Matrix6 diagonal = Matrix6::Zero();
  const double known[6] = {7, -2, 4, 1e-3, 5, 3}, ascending[6] = {-2, 1e-3, 3, 4, 5, 7};
  for (int k = 0; k < 6; ++k)
    diagonal(k, k) = known[k];
  const Matrix6 m = rotate(MandelStiffness{diagonal}, rotation_about({1, -2, 0.5}, 0.8)).matrix;
  const EigenSystem system = eigen_system(m);
  for (int k = 0; k < 6; ++k) {
    CHECK(std::abs(system.values[k] - ascending[k]) < 7e-14);
    const Eigen::Matrix<double, 6, 1> v = system.vectors.col(k);
    CHECK((m * v - system.values[k] * v).norm() < 7e-14);
  }
  CHECK((system.vectors.transpose() * system.vectors - Matrix6::Identity()).norm() < 1e-14);
}
