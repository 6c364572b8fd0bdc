// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/contact/friction.hpp>

#include <cmath>
#include <numbers>

#include <granum/core/error.hpp>

namespace granum::contact {

Friction Friction::from_coefficient(double coefficient) {
  return Friction(require_non_negative("friction_coefficient", coefficient));
}

Friction Friction::from_angle(double angle) {
  if (!(angle >= 0 && angle < std::numbers::pi / 2))
    throw InvalidArgument("friction_angle", angle, "rad", "[0, pi/2)");
  return Friction(std::tan(angle));
}

double Friction::angle() const { return std::atan(coefficient_); }

} // namespace granum::contact
