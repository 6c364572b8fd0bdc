// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/elastic/projection.hpp>

#include <granum/core/error.hpp>
#include <granum/elastic/mandel.hpp>

#include "direction.hpp"
#include "isotropic_part.hpp"

namespace granum::elastic {

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
