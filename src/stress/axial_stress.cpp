// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/stress/axial_stress.hpp>

#include <cmath>

#include <granum/core/error.hpp>

namespace granum::stress {

double mobilised_friction_angle(const AxialStress& stress) {
  require_non_negative("vertical stress", stress.v, "Pa");
  require_non_negative("horizontal stress", stress.h, "Pa");
  require_positive("sum of the stresses", stress.v + stress.h, "Pa");
  return std::asin(std::abs(stress.v - stress.h) / (stress.v + stress.h));
}

} // namespace granum::stress
