// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/elastic/averages.hpp>

#include <algorithm>

#include <Eigen/Cholesky>
#include <granum/core/error.hpp>
#include <granum/elastic/mandel.hpp>

#include "isotropic_part.hpp"

namespace granum::elastic {

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

IsotropicAverages isotropic_averages(const VoigtStiffness& stiffness) {
  const MandelStiffness c = mandel(stiffness);
  if (!positive_definite(c))
    throw InvalidArgument(
        "averages need a positive definite stiffness: a mode without stiffness has no compliance");
  const Matrix6 symmetric = c.matrix / 2 + c.matrix.transpose() / 2;
  const Matrix6 compliance = symmetric.llt().solve(Matrix6::Identity());
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

} // namespace granum::elastic
