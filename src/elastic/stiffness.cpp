// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/elastic/stiffness.hpp>

#include <cmath>
#include <numbers>

#include <granum/core/error.hpp>
#include <granum/elastic/isotropic.hpp>

#include "core/compiled_once.hpp"
#include "parts.hpp"

namespace granum::elastic {

EigenSystem eigen_system(const Matrix6& symmetric) {
  const SymmetricEigen<6> system = symmetric_eigen<6>(symmetric);
  return {.values = system.values, .vectors = system.vectors};
}

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

namespace {

/// \param    m   symmetric Mandel matrix, here and below
Matrix6 cubic_part(const Matrix6& m) {
  const double shear = m.bottomRightCorner<3, 3>().trace() / 3;
  const double axial = m.topLeftCorner<3, 3>().trace() / 3;
  const double coupling = (m(0, 1) + m(1, 2) + m(0, 2)) / 3;
  Matrix6 part = shear * Matrix6::Identity();
  part.topLeftCorner<3, 3>().setConstant(coupling);
  part.topLeftCorner<3, 3>().diagonal().setConstant(axial);
  return part;
}

Matrix6 orthotropic_part(const Matrix6& m) {
  Matrix6 part = m.diagonal().asDiagonal();
  part.topLeftCorner<3, 3>() = m.topLeftCorner<3, 3>();
  return part;
}

} // namespace

SymmetryDistances symmetry_distances(const VoigtStiffness& stiffness) {
  require_symmetric<6>("stiffness", stiffness.matrix);
  const double scale = stiffness.matrix.cwiseAbs().maxCoeff();
  if (scale == 0)
    throw InvalidArgument("the symmetry of a stiffness that is zero has no meaning");
  const VoigtStiffness scaled{stiffness.matrix / scale}; // no square leaves the range of doubles
  const Matrix6 m = mandel(scaled).matrix;
  const MandelStiffness c{(m + m.transpose()) / 2};
  const auto distance = [&c](const Matrix6& part) { return relative_distance(c, {part}); };
  return {.isotropic = distance(mandel_matrix(isotropic_part(c.matrix))),
          .cubic = distance(cubic_part(c.matrix)),
          .transversely_isotropic = distance(mandel(voigt(transversely_isotropic_projection(scaled))).matrix),
          .orthotropic = distance(orthotropic_part(c.matrix))};
}

} // namespace granum::elastic
