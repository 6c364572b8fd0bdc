// SPDX-License-Identifier: GPL-3.0-or-later
// Sphere contacts that follow the mean strain.
#pragma once

#include <cmath>

#include "sphere_checks.hpp"

namespace granum::rock_physics::sphere {

/// P k_n of a contact under the strain e along its normal [Pa].
template <class Packing>
double contact_modulus(const Packing& s, double strain) {
  return 9 * stiffness_density(s) * s.shear_modulus * std::sqrt(strain);
}

} // namespace granum::rock_physics::sphere
