// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/rock_physics/sphere_packing.hpp>

#include <cmath>
#include <limits>

#include "sphere_checks.hpp"

namespace granum::rock_physics {

namespace {

/// True only for packings that the checks below pass without a note: the usual case, in a few comparisons.
bool unremarkable(const SpherePacking& s) {
  return s.shear_modulus > 0 && s.shear_modulus <= std::numeric_limits<double>::max() &&
         s.poisson_ratio > -1 && s.poisson_ratio <= 0.5 && s.porosity >= 0 && s.porosity < 1 &&
         s.coordination_number > 0 && s.coordination_number <= 12 && s.no_slip_fraction >= 0 &&
         s.no_slip_fraction <= 1 && s.pressure >= 0 &&
         s.pressure < 2e-3 * sphere::stiffness_density(s) * s.shear_modulus;
}

void note_load(const SpherePacking& s, Validity& validity) {
  if (s.pressure == 0)
    return;
  if (s.coordination_number == 0)
    return validity.add("no contacts carry the pressure: the moduli are zero");
  const double contact_radius_cubed = s.pressure / s.shear_modulus / (2 * sphere::stiffness_density(s));
  if (contact_radius_cubed > 1e-3)
    sphere::note_contact_radius(std::cbrt(contact_radius_cubed), validity);
}

} // namespace

Validity require_valid(const SpherePacking& s) {
  if (unremarkable(s))
    return {};
  sphere::require_grain(s);
  require_non_negative("pressure", s.pressure, "Pa");
  require_closed("no_slip_fraction", s.no_slip_fraction, 0, 1);

  Validity validity;
  sphere::note_coordination(s, validity);
  note_load(s, validity);
  return validity;
}

} // namespace granum::rock_physics
