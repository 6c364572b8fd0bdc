// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/elastic/projection.hpp>

namespace granum::elastic {

Isotropic isotropic_projection(const VoigtStiffness& stiffness) {
  const Matrix6& c = stiffness.matrix;
  const double block = c.topLeftCorner<3, 3>().sum();
  const double diagonal = c.topLeftCorner<3, 3>().trace();
  const double shear = c.bottomRightCorner<3, 3>().trace();
  // block - diagonal = 2 (C12+C13+C23)
  return Isotropic::from_bulk_and_shear(block / 9, shear / 5 + (diagonal - (block - diagonal) / 2) / 15);
}

TransverselyIsotropic transversely_isotropic_projection(const VoigtStiffness& stiffness) {
  const Matrix6 c = (stiffness.matrix + stiffness.matrix.transpose()) / 2;
  const double diagonal = c(0, 0) + c(1, 1);
  return {.C11 = (3 * diagonal + 2 * c(0, 1) + 4 * c(5, 5)) / 8,
          .C33 = c(2, 2),
          .C12 = (diagonal + 6 * c(0, 1) - 4 * c(5, 5)) / 8,
          .C13 = (c(0, 2) + c(1, 2)) / 2,
          .C44 = (c(3, 3) + c(4, 4)) / 2};
}

} // namespace granum::elastic
