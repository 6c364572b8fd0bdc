// SPDX-License-Identifier: GPL-3.0-or-later
// Checks and factors that the classical models of equal spheres share. Packing is any of their argument
// types: all have shear_modulus, poisson_ratio, porosity and coordination_number.
#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <string_view>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>

namespace granum::rock_physics::sphere {

/// Throws unless the members that every packing has are possible.
template <class Packing>
void require_grain(const Packing& s) {
  require_positive("shear_modulus", s.shear_modulus, "Pa");
  require_poisson_ratio("poisson_ratio", s.poisson_ratio);
  if (!(s.porosity >= 0 && s.porosity < 1))
    throw InvalidArgument("porosity", s.porosity, "", "[0, 1)");
  require_non_negative("coordination_number", s.coordination_number);
}

/// A small compression.
inline void require_strain(std::string_view name, double strain) {
  if (!(strain >= 0 && strain < 1))
    throw InvalidArgument(std::string(name), strain, "", "[0, 1)");
}

/// Equal spheres cannot have more contacts.
template <class Packing>
void note_coordination(const Packing& s, Validity& validity) {
  if (s.coordination_number > 12)
    validity.add("coordination number exceeds 12, the most that equal spheres can have");
}

/// Contacts of the half-space must be small. `contact_radius` by grain radius.
inline void note_contact_radius(double contact_radius, Validity& validity) {
  if (contact_radius > 0.1)
    validity.add(
        detail::formatted("contact radius is %.3g grain radii: Hertz contacts must be small against the "
                          "grain (0.1); are all numbers in the same units?",
                          contact_radius));
}

/// C_n (1-phi)/(3 pi (1-nu_g)): K = stiffness_density G_g a/R for contacts of radius a.
template <class Packing>
double stiffness_density(const Packing& s) {
  return s.coordination_number * (1 - s.porosity) / (3 * std::numbers::pi * (1 - s.poisson_ratio));
}

/// k_t/k_n of no-slip contacts; poisson_ratio is checked already.
inline double no_slip_ratio(double poisson_ratio) { return 2 * (1 - poisson_ratio) / (2 - poisson_ratio); }

/// Mean k_t/k_n where only a share of the contacts does not slip.
template <class Packing>
double mean_tangential_ratio(const Packing& s) {
  return s.no_slip_fraction * no_slip_ratio(s.poisson_ratio);
}

/// P k_n of a contact under the strain e along its normal [Pa], where contacts follow the mean strain.
template <class Packing>
double contact_modulus(const Packing& s, double strain) {
  return 9 * stiffness_density(s) * s.shear_modulus * std::sqrt(strain);
}

} // namespace granum::rock_physics::sphere
