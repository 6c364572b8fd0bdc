// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/hertz_mindlin.hpp>

#include <cmath>
#include <numbers>

#include "sphere_pack.hpp"

namespace granum::effective {

namespace {

/// (m^2 p/(18 pi^2))^(1/3); one root where the product is safe from overflow and loss of digits.
double bulk_modulus(double m, double p) {
  constexpr double divisor = 18 * std::numbers::pi * std::numbers::pi;
  const double product = m * m * p;
  if (product > 1e-290 && product < 1e300)
    return std::cbrt(product / divisor);
  const double root = std::cbrt(m);
  return root * root * (p < 1 ? std::cbrt(p / divisor * 1e30) * 1e-10 : std::cbrt(p / divisor));
}

} // namespace

IsotropicModuli hertz_mindlin(const SpherePack& pack, double no_slip_share) {
  require_valid(pack);
  const double r = slipping_ratio(pack.grain, no_slip_share);
  const double K = bulk_modulus(contact_modulus(pack), pack.pressure);
  return {.bulk_modulus = K, .shear_modulus = K * (0.3 * (2 + 3 * r))};
}

} // namespace granum::effective
