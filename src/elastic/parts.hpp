// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include <granum/core/error.hpp>
#include <granum/core/vec3.hpp>
#include <granum/elastic/stiffness.hpp>

namespace granum::elastic {

/// The unit vector along `vector`, whatever its length.
/// \throws   InvalidArgument for the zero vector or one that is not finite
inline Vec3 unit_along(const char* name, const Vec3& vector) {
  Vec3 v = vector;
  double square = dot(v, v);
  if (!(square > 1e-200 && square < 1e200)) { // squares near the ends of the range of doubles, or none at all
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z) || largest == 0)
      throw InvalidArgument(std::string(name) + " must be a finite vector other than zero");
    v = {v.x / largest, v.y / largest, v.z / largest};
    square = dot(v, v);
  }
  const double length = std::sqrt(square);
  return {v.x / length, v.y / length, v.z / length};
}

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
