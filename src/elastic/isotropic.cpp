// SPDX-License-Identifier: GPL-3.0-or-later
// Notation: w = G/(3K) in [0, inf); nu = (1-2w)/(2(1+w)) and E = 3G/(1+w) stay finite for an infinite K.
#include <granum/elastic/isotropic.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <Eigen/Cholesky>

#include <granum/core/error.hpp>
#include <granum/elastic/stiffness.hpp>

#include "parts.hpp"

namespace granum::elastic {

Isotropic Isotropic::from_bulk_and_shear(double bulk_modulus, double shear_modulus) {
  if (!(bulk_modulus > 0))
    throw InvalidArgument("bulk_modulus", bulk_modulus, "Pa", "(0, inf]");
  return {bulk_modulus, require_positive("shear_modulus", shear_modulus, "Pa")};
}

Isotropic Isotropic::from_young_and_poisson(double young_modulus, double poisson_ratio) {
  require_positive("young_modulus", young_modulus, "Pa");
  require_poisson_ratio("poisson_ratio", poisson_ratio);
  return {young_modulus / (3 * (1 - 2 * poisson_ratio)), young_modulus / (2 * (1 + poisson_ratio))};
}

Isotropic Isotropic::from_shear_and_poisson(double shear_modulus, double poisson_ratio) {
  require_positive("shear_modulus", shear_modulus, "Pa");
  require_poisson_ratio("poisson_ratio", poisson_ratio);
  return {2 * shear_modulus * (1 + poisson_ratio) / (3 * (1 - 2 * poisson_ratio)), shear_modulus};
}

Isotropic Isotropic::from_lame(double lame_lambda, double shear_modulus) {
  require_positive("shear_modulus", shear_modulus, "Pa");
  const double bulk_modulus = require_finite("lame_lambda", lame_lambda, "Pa") + 2 * shear_modulus / 3;
  if (!(bulk_modulus > 0))
    throw InvalidArgument("lame_lambda", lame_lambda, "Pa", "(-2/3 shear_modulus, inf)");
  return {bulk_modulus, shear_modulus};
}

double Isotropic::young_modulus() const {
  return 3 * shear_modulus_ / (1 + shear_modulus_ / (3 * bulk_modulus_));
}

double Isotropic::poisson_ratio() const {
  if (bulk_modulus_ < shear_modulus_) { // the same in 1/w, which stays finite for a tiny K
    const double inverse = 3 * bulk_modulus_ / shear_modulus_;
    return (inverse - 2) / (2 * (inverse + 1));
  }
  const double w = shear_modulus_ / (3 * bulk_modulus_);
  return (1 - 2 * w) / (2 * (1 + w));
}

TransverselyIsotropic transversely_isotropic(const Isotropic& solid) {
  if (std::isinf(solid.bulk_modulus()))
    throw InvalidArgument("an incompressible solid (Poisson's ratio 0.5) has no stiffness matrix");
  const double lambda = solid.lame_lambda();
  const double axial = lambda + 2 * solid.shear_modulus();
  return {.C11 = axial, .C33 = axial, .C12 = lambda, .C13 = lambda, .C44 = solid.shear_modulus()};
}

VoigtStiffness voigt(const Isotropic& solid) { return voigt(transversely_isotropic(solid)); }

namespace {

double middle(double a, double b) { return a / 2 + b / 2; }

/// \param    stiffness, compliance   isotropic parts of the two
IsotropicAverages averages(const IsotropicPart& stiffness, const IsotropicPart& compliance) {
  const double K_v = stiffness.volumetric / 3, G_v = stiffness.deviatoric / 2;
  const double K_r = std::min(1 / (3 * compliance.volumetric), K_v);
  const double G_r = std::min(1 / (2 * compliance.deviatoric), G_v);
  return {.voigt = Isotropic::from_bulk_and_shear(K_v, G_v),
          .hill = Isotropic::from_bulk_and_shear(middle(K_v, K_r), middle(G_v, G_r)),
          .reuss = Isotropic::from_bulk_and_shear(K_r, G_r)};
}

} // namespace

namespace {

// Where a symmetric matrix has a condition number far from that of rounding, its Cholesky factor L says all
// that is asked; elsewhere eigenvalues do, which take ten times as long. The trace of the inverse is |L^-1|^2
// and no smaller than its largest eigenvalue, as the norm of the matrix is than its own.
constexpr double clear_condition = 1e6;

/// L^-1, if it is clear.
std::optional<Matrix6> clear_root_of_inverse(const Matrix6& symmetric) {
  const Eigen::LLT<Matrix6> factor(symmetric);
  if (factor.info() != Eigen::Success)
    return std::nullopt;
  const Matrix6 root = factor.matrixL().solve(Matrix6::Identity());
  return root.squaredNorm() * symmetric.norm() < clear_condition ? std::optional(root) : std::nullopt;
}

} // namespace

IsotropicAverages isotropic_averages(const VoigtStiffness& stiffness) {
  const MandelStiffness c = mandel(stiffness);
  require_symmetric<6>("stiffness", c.matrix);
  const Matrix6 symmetric = c.matrix / 2 + c.matrix.transpose() / 2;
  Matrix6 compliance;
  if (const std::optional<Matrix6> root = clear_root_of_inverse(symmetric))
    compliance.noalias() = root->transpose() * *root;
  else if (positive_definite(c))
    compliance = symmetric.llt().solve(Matrix6::Identity());
  else
    throw InvalidArgument(
        "averages need a positive definite stiffness: a mode without stiffness has no compliance");
  return averages(isotropic_part(symmetric), isotropic_part(compliance));
}

IsotropicAverages isotropic_averages(const TransverselyIsotropic& c) {
  const TransverselyIsotropicCompliance s = compliance(c);
  const auto part = [](double m11, double m33, double m12, double m13, double mandel_shear) {
    // the shears on the Mandel basis: twice, and m11 - m12 of the horizontal plane
    const double horizontal = m11 - m12, vertical = (m11 - m13) + (m33 - m13);
    return IsotropicPart{.volumetric = (2 * (m11 + m12) + m33 + 4 * m13) / 3,
                         .deviatoric = (2 * (horizontal + vertical) / 3 + 2 * mandel_shear + horizontal) / 5};
  };
  return averages(part(c.C11, c.C33, c.C12, c.C13, 2 * c.C44), part(s.S11, s.S33, s.S12, s.S13, s.S44 / 2));
}

namespace {

/// 1/S_kk of one of the first three axes, S the inverse of the Mandel matrix: there it is that of Voigt.
double youngs_modulus(const EigenSystem& system, int axis) {
  constexpr double rounding = 1e-13;
  const double softest = rounding * system.values[5];
  double compliance = 0;
  for (int k = 0; k < 6; ++k) {
    const double share = system.vectors(axis, k) * system.vectors(axis, k);
    if (system.values[k] > softest)
      compliance += share / system.values[k];
    else if (share > rounding)
      return 0;
  }
  return compliance > 0 ? 1 / compliance : 0;
}

} // namespace

EngineeringModuli engineering_moduli(const VoigtStiffness& stiffness) {
  const Matrix6& c = stiffness.matrix;
  require_symmetric<6>("stiffness", c);
  const double scale = c.cwiseAbs().maxCoeff();
  if (scale == 0)
    return {};
  const Matrix6 m = mandel(VoigtStiffness{c / scale}).matrix;
  const Matrix6 symmetric = (m + m.transpose()) / 2;
  std::array<double, 3> young{};
  if (const std::optional<Matrix6> root = clear_root_of_inverse(symmetric)) {
    for (int k = 0; k < 3; ++k)
      young[static_cast<std::size_t>(k)] = 1 / root->col(k).squaredNorm();
  } else {
    const EigenSystem system = eigen_system(symmetric);
    for (int k = 0; k < 3; ++k)
      young[static_cast<std::size_t>(k)] = youngs_modulus(system, k);
  }
  return {.bulk_modulus = c.topLeftCorner<3, 3>().sum() / 9,
          .E_1 = scale * young[0],
          .E_2 = scale * young[1],
          .E_3 = scale * young[2],
          .C44 = c(3, 3),
          .C55 = c(4, 4),
          .C66 = c(5, 5)};
}

namespace {

/// The shortest rotation that turns `axis`, or its opposite, to axis 3.
Mat3 rotation_to_axis_3(const Vec3& axis) {
  Vec3 n = unit_along("axis", axis);
  if (n.z < 0) // keeps 1 + n.z away from zero
    n = -n;
  const double f = 1 / (1 + n.z);
  return {{{1 - f * n.x * n.x, -f * n.x * n.y, -n.x},
           {-f * n.x * n.y, 1 - f * n.y * n.y, -n.y},
           {n.x, n.y, n.z}}};
}

} // namespace

Isotropic isotropic_projection(const VoigtStiffness& stiffness) {
  require_symmetric<6>("stiffness", stiffness.matrix);
  const IsotropicPart part = isotropic_part(mandel(stiffness).matrix);
  return Isotropic::from_bulk_and_shear(part.volumetric / 3, part.deviatoric / 2);
}

double projected_shear_modulus(const TransverselyIsotropic& c) {
  return (2 * c.C44 + c.C66()) / 5 + (2 * c.C11 + c.C33 - c.C12 - 2 * c.C13) / 15;
}

TransverselyIsotropic transversely_isotropic_projection(const VoigtStiffness& stiffness) {
  require_symmetric<6>("stiffness", stiffness.matrix);
  const Matrix6 c = (stiffness.matrix + stiffness.matrix.transpose()) / 2;
  const double diagonal = c(0, 0) + c(1, 1);
  return {.C11 = (3 * diagonal + 2 * c(0, 1) + 4 * c(5, 5)) / 8,
          .C33 = c(2, 2),
          .C12 = (diagonal + 6 * c(0, 1) - 4 * c(5, 5)) / 8,
          .C13 = (c(0, 2) + c(1, 2)) / 2,
          .C44 = (c(3, 3) + c(4, 4)) / 2};
}

TransverselyIsotropic transversely_isotropic_projection(const VoigtStiffness& stiffness, const Vec3& axis) {
  return transversely_isotropic_projection(rotate(stiffness, rotation_to_axis_3(axis)));
}

VoigtStiffness voigt(const TransverselyIsotropic& stiffness, const Vec3& axis) {
  return rotate(voigt(stiffness), transpose(rotation_to_axis_3(axis)));
}

} // namespace granum::elastic
