// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/elastic/mandel.hpp>

#include <cmath>
#include <numbers>

#include <granum/core/error.hpp>
#include <granum/elastic/eigen_system.hpp>

namespace granum::elastic {

namespace {

using Vector6 = Eigen::Vector<double, 6>;

constexpr double root_half = 1 / std::numbers::sqrt2;
constexpr int row_of[6] = {0, 1, 2, 1, 0, 0};
constexpr int column_of[6] = {0, 1, 2, 2, 2, 1};

/// Factors from Voigt shears to Mandel shears.
Vector6 weights() {
  Vector6 w;
  w << 1, 1, 1, std::numbers::sqrt2, std::numbers::sqrt2, std::numbers::sqrt2;
  return w;
}

/// The k-th tensor of the orthonormal basis.
Mat3 basis_tensor(int k) {
  Mat3 t;
  t(row_of[k], column_of[k]) = t(column_of[k], row_of[k]) = k < 3 ? 1 : root_half;
  return t;
}

void require_rotation(const Mat3& r) {
  const Mat3 product = transpose(r) * r;
  bool proper = determinant(r) > 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      proper = proper && std::abs(product(i, j) - (i == j ? 1 : 0)) <= 1e-10;
  if (!proper)
    throw InvalidArgument("rotation must be a proper rotation matrix: R^T R = 1, det R = 1");
}

} // namespace

MandelStiffness mandel(const VoigtStiffness& stiffness) {
  return {weights().asDiagonal() * stiffness.matrix * weights().asDiagonal()};
}

VoigtStiffness voigt(const MandelStiffness& stiffness) {
  const Vector6 inverse = weights().cwiseInverse();
  return {inverse.asDiagonal() * stiffness.matrix * inverse.asDiagonal()};
}

Matrix6 mandel_rotation(const Mat3& rotation) {
  require_rotation(rotation);
  Matrix6 q;
  for (int k = 0; k < 6; ++k) {
    const Mat3 turned = rotation * basis_tensor(k) * transpose(rotation);
    for (int i = 0; i < 6; ++i)
      q(i, k) = turned(row_of[i], column_of[i]) * (i < 3 ? 1 : std::numbers::sqrt2);
  }
  return q;
}

MandelStiffness rotate(const MandelStiffness& stiffness, const Mat3& rotation) {
  require_symmetric<6>("stiffness", stiffness.matrix);
  const Matrix6 q = mandel_rotation(rotation);
  return {q * stiffness.matrix * q.transpose()};
}

VoigtStiffness rotate(const VoigtStiffness& stiffness, const Mat3& rotation) {
  return voigt(rotate(mandel(stiffness), rotation));
}

double relative_smallest_eigenvalue(const MandelStiffness& stiffness) {
  require_symmetric<6>("stiffness", stiffness.matrix);
  const double scale = stiffness.matrix.cwiseAbs().maxCoeff();
  if (scale == 0)
    return 0;
  const Matrix6 scaled = stiffness.matrix / scale;
  const Matrix6 symmetric = (scaled + scaled.transpose()) / 2;
  const Vector6 values = eigen_system(symmetric).values;
  const double largest = values.cwiseAbs().maxCoeff();
  return largest > 0 ? values[0] / largest : 0;
}

bool positive_definite(const MandelStiffness& stiffness, double tolerance) {
  return relative_smallest_eigenvalue(stiffness) > tolerance;
}

bool positive_semidefinite(const MandelStiffness& stiffness, double tolerance) {
  return relative_smallest_eigenvalue(stiffness) >= -tolerance;
}

double symmetry_residual(const MandelStiffness& stiffness) {
  return relative_distance(stiffness, {stiffness.matrix.transpose()});
}

double relative_distance(const MandelStiffness& a, const MandelStiffness& b) {
  const double difference = (a.matrix - b.matrix).norm();
  if (difference == 0)
    return 0;
  if (a.matrix.norm() == 0)
    throw InvalidArgument("a distance relative to a zero stiffness has no meaning");
  return difference / a.matrix.norm();
}

} // namespace granum::elastic
