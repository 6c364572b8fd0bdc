// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/rock_physics/digby.hpp>

#include <cmath>

#include "sphere_checks.hpp"

namespace granum::rock_physics {

namespace {

Validity checked(const BondedPacking& p) {
  sphere::require_grain(p);
  require_non_negative("pressure", p.pressure, "Pa");
  if (!(p.bond_radius_ratio >= 0 && p.bond_radius_ratio < 1))
    throw InvalidArgument("bond_radius_ratio", p.bond_radius_ratio, "", "[0, 1)");
  Validity validity;
  sphere::note_coordination(p, validity);
  return validity;
}

/// The real root of d^3 + 3 m d = q for m, q >= 0. Cardano's difference t - m/t, multiplied out into a
/// quotient of positive terms.
double monotone_cubic_root(double m, double q) {
  const double t = std::cbrt(q / 2 + std::hypot(q / 2, m * std::sqrt(m)));
  if (t == 0)
    return 0;
  const double other = m / t;
  return q / (t * t + m + other * other);
}

/// Contact radius a by grain radius from the bond radius b; p/(2 modulus) is the cube of the radius without
/// bonds. Lengths are measured in 2^-100 grain radii, so that tiny pressures keep their digits.
double contact_radius(double b, double pressure, double modulus) {
  constexpr double radius = 0x1p100;
  const double bond = b * radius;
  const double d =
      monotone_cubic_root(bond * bond / 2, pressure * (radius * radius * radius) / (2 * modulus));
  return std::sqrt(d * d + bond * bond) / radius;
}

} // namespace

IsotropicEstimate digby(const BondedPacking& packing) {
  IsotropicEstimate estimate{.bulk_modulus = 0, .shear_modulus = 0, .validity = checked(packing)};
  const double modulus = sphere::stiffness_density(packing) * packing.shear_modulus;
  if (modulus == 0)
    return estimate;
  const double b = packing.bond_radius_ratio;
  const double a = contact_radius(b, packing.pressure, modulus);
  sphere::note_contact_radius(a, estimate.validity);
  estimate.bulk_modulus = modulus * a;
  estimate.shear_modulus = modulus * (0.6 * a + 0.9 * sphere::no_slip_ratio(packing.poisson_ratio) * b);
  return estimate;
}

} // namespace granum::rock_physics
