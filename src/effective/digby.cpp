// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/digby.hpp>

#include <cmath>
#include <numbers>

#include "sphere_pack.hpp"

namespace granum::effective {

namespace {

/// The root of d^3 + 3 q d = 2 t for q, t >= 0. Cardano's u - v with u v = q, written without the difference.
double monotone_cubic_root(double q, double t) {
  if (t == 0)
    return 0;
  const double u = std::cbrt(t + std::sqrt(t * t + q * q * q));
  const double v = q / u;
  return 2 * t / (u * u + q + v * v);
}

} // namespace

IsotropicModuli digby(const SpherePack& pack, double bond_radius_ratio) {
  require_valid(pack);
  const double b = require_non_negative("bond_radius_ratio", bond_radius_ratio);
  const double m = contact_modulus(pack);
  if (m == 0)
    return {};
  // (a/R)^2 = d^2 + b^2 with d^3 + 3/2 b^2 d = 3 pi p/(2 m).
  const double d = monotone_cubic_root(b * b / 2, 0.75 * std::numbers::pi * (pack.pressure / m));
  const double normal = 4 * m * std::sqrt(d * d + b * b);
  const double nu = pack.grain.poisson_ratio;
  const double tangential = 8 * m * b * ((1 - nu) / (2 - nu));
  return {.bulk_modulus = normal / (12 * std::numbers::pi),
          .shear_modulus = (normal + 1.5 * tangential) / (20 * std::numbers::pi)};
}

} // namespace granum::effective
