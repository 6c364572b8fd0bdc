// SPDX-License-Identifier: GPL-3.0-or-later
// Notation: w = G/(3K) in [0, inf); nu = (1-2w)/(2(1+w)) and E = 3G/(1+w) stay finite for an infinite K.
#include <granum/elastic/isotropic.hpp>

#include <cmath>

#include <granum/core/error.hpp>

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

} // namespace granum::elastic
