// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/fabric/measures.hpp>

#include <algorithm>
#include <cmath>

#include <granum/core/error.hpp>
#include <granum/fabric/orientation.hpp>

namespace granum::fabric {

namespace {

/// Every measure from the coefficient of P2; its caller puts the measure that was given back in place. Clamps
/// undo the rounding at the ends of the range of unit vectors.
FabricMeasures from_coefficient(double a_c) {
  FabricMeasures m{.anisotropy = 3 * a_c / (4 + a_c),
                   .F11 = std::clamp((5 - a_c) / 15, 0.0, 0.5),
                   .F33 = std::clamp((5 + 2 * a_c) / 15, 0.0, 1.0),
                   .P2_coefficient = a_c,
                   .mean_cos_2gamma = std::clamp((4 * a_c - 5) / 15, -1.0, 1.0),
                   .validity = {}};
  return m;
}

FabricMeasures with_validity(FabricMeasures m) {
  m.validity = anisotropy_validity(m.anisotropy);
  return m;
}

} // namespace

FabricMeasures measures_from_anisotropy(double anisotropy) {
  const double a = require_closed("fabric_anisotropy", anisotropy, -5, 5.0 / 3);
  FabricMeasures m = from_coefficient(4 * a / (3 - a));
  m.anisotropy = a;
  return with_validity(m);
}

FabricMeasures measures_from_F33(double F33) {
  require_closed("F33", F33, 0, 1);
  FabricMeasures m = from_coefficient(2.5 * std::fma(3, F33, -1));
  m.F33 = F33;
  return with_validity(m);
}

FabricMeasures measures_from_P2_coefficient(double P2_coefficient) {
  return with_validity(from_coefficient(require_closed("P2_coefficient", P2_coefficient, -2.5, 5)));
}

FabricMeasures measures_from_mean_cos_2gamma(double mean_cos_2gamma) {
  require_closed("mean_cos_2gamma", mean_cos_2gamma, -1, 1);
  FabricMeasures m = from_coefficient(1.25 * std::fma(3, mean_cos_2gamma, 1));
  m.mean_cos_2gamma = mean_cos_2gamma;
  return with_validity(m);
}

Mat3 contact_tensor(const Mat3& fabric) {
  require_symmetric<3>("fabric", fabric);
  require_closed("trace of the fabric tensor", trace(fabric), 1 - 1e-6, 1 + 1e-6);
  return 7.5 * (fabric + (-1.0 / 3) * Mat3::identity());
}

Mat3 fabric_from_contact_tensor(const Mat3& contact_tensor) {
  require_symmetric<3>("contact_tensor", contact_tensor);
  require_closed("trace of the contact tensor", trace(contact_tensor), -1e-5, 1e-5);
  return (1 / 7.5) * contact_tensor + (1.0 / 3) * Mat3::identity();
}

} // namespace granum::fabric
