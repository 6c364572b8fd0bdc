// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/elastic/symmetry.hpp>

#include <granum/core/error.hpp>
#include <granum/elastic/mandel.hpp>
#include <granum/elastic/projection.hpp>

#include "isotropic_part.hpp"

namespace granum::elastic {

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
