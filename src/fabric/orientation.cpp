// SPDX-License-Identifier: GPL-3.0-or-later
// Notation: a anisotropy of E(gamma) = 3 (1 + a cos 2 gamma)/(4 pi (3 - a)).
#include <granum/fabric/orientation.hpp>

#include <cmath>
#include <numbers>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>

namespace granum::fabric {

double density(double polar_angle, double anisotropy) {
  require_finite("polar_angle", polar_angle, "rad");
  const double a = require_closed("fabric_anisotropy", anisotropy, -1, 1);
  return 3 * (1 + a * std::cos(2 * polar_angle)) / (4 * std::numbers::pi * (3 - a));
}

SecondMoments second_moments(double anisotropy) {
  const double a = require_closed("fabric_anisotropy", anisotropy, -5, 5.0 / 3);
  const double scale = 5 * (3 - a);
  return {.F11 = (5 - 3 * a) / scale, .F33 = (5 + a) / scale};
}

FourthMoments fourth_moments(double anisotropy) {
  const double a = require_closed("fabric_anisotropy", anisotropy, -7.0 / 3, 7.0 / 5);
  const double scale = 35 * (3 - a);
  return {.n1111 = 3 * (7 - 5 * a) / scale,
          .n3333 = 3 * (7 + 3 * a) / scale,
          .n1122 = (7 - 5 * a) / scale,
          .n1133 = (7 - a) / scale};
}

double anisotropy_from_F33(double F33) {
  require_closed("F33", F33, 0, 1);
  return 5 * (3 * F33 - 1) / (5 * F33 + 1);
}

Validity anisotropy_validity(double anisotropy) {
  Validity validity;
  if (std::abs(anisotropy) > 1)
    validity.add("fabric anisotropy " + detail::refused_text(anisotropy, "[-1, 1]", 4) +
                 " is outside [-1, 1]: the density of contact normals is negative in some directions");
  return validity;
}

} // namespace granum::fabric
