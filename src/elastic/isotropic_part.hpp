// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/elastic/stiffness.hpp>

namespace granum::elastic {

/// The isotropic tensor volumetric J + deviatoric (1 - J), J the projector on volume changes, that is nearest
/// to a fourth-rank tensor: {3K, 2G} of a stiffness, {1/(3K), 1/(2G)} of a compliance. [Moakher2006]
struct IsotropicPart {
  double volumetric;
  double deviatoric;
};

/// \param    m   the tensor on the Mandel basis
inline IsotropicPart isotropic_part(const Matrix6& m) {
  const auto coupling = [&m](int i, int j) { return m(i, j) / 2 + m(j, i) / 2; };
  const double shear = (m(0, 0) - coupling(0, 1)) + (m(1, 1) - coupling(1, 2)) + (m(2, 2) - coupling(2, 0));
  return {.volumetric = m.topLeftCorner<3, 3>().sum() / 3,
          .deviatoric = (2 * shear / 3 + m.bottomRightCorner<3, 3>().trace()) / 5};
}

/// The part as a matrix on the Mandel basis.
inline Matrix6 mandel_matrix(const IsotropicPart& part) {
  Matrix6 m = part.deviatoric * Matrix6::Identity();
  m.topLeftCorner<3, 3>().array() += (part.volumetric - part.deviatoric) / 3;
  return m;
}

} // namespace granum::elastic
