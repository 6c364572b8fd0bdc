// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/rock_physics/hertz_mindlin.hpp>

#include <cmath>
#include <limits>

#include "sphere_checks.hpp"

namespace granum::rock_physics {

namespace {

/// (x^2 y)^(1/3) of x, y >= 0. The cubed value may leave the range of a double where the root does not.
double cube_root_of_square(double x, double y) {
  constexpr double smallest = std::numeric_limits<double>::min();
  const double cubed = x * x * y;
  if (cubed >= smallest && std::isfinite(cubed))
    return std::cbrt(cubed);
  const double root = std::cbrt(x);
  return root * root * std::cbrt(y);
}

} // namespace

IsotropicEstimate hertz_mindlin(const SpherePacking& packing) {
  IsotropicEstimate estimate{.bulk_modulus = 0, .shear_modulus = 0, .validity = require_valid(packing)};
  // K^3 = (stiffness_density G)^2 p/2
  const double modulus = sphere::stiffness_density(packing) * packing.shear_modulus;
  estimate.bulk_modulus = cube_root_of_square(modulus, packing.pressure / 2);
  estimate.shear_modulus = estimate.bulk_modulus * (0.6 + 0.9 * sphere::mean_tangential_ratio(packing));
  return estimate;
}

} // namespace granum::rock_physics
