// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include <granum/estimate/answer.hpp>

#include "effective/support.hpp"

/// Questions that the tests of this module begin with.
namespace granum::test {

/// Cones, spheres, flat punches or another profile of the grains of the paper, contacts unknown.
inline estimate::Question grains_of(double alpha, double a, double stress_v, double stress_h) {
  const contact::GrainMaterial grain{.shear_modulus = 30e9, .poisson_ratio = 0.15};
  const auto law = alpha == 1          ? contact::PowerLaw::cone(grain, 0.4)
                   : alpha == 2        ? contact::PowerLaw::sphere(grain, 0.5e-3)
                   : std::isinf(alpha) ? contact::PowerLaw::flat(grain, 5.7e-6)
                                       : contact::PowerLaw::general(grain, alpha, 180);
  return {.state = {.law = law,
                    .tangential_ratio = contact::mindlin_stiffness_ratio(0.15),
                    .radius = 0.5e-3,
                    .void_ratio = 0.558,
                    .fabric_anisotropy = a,
                    .stress_v = stress_v,
                    .stress_h = stress_h},
          .grain_density = 2650};
}

/// The fabric of a question as an uncertain input.
inline estimate::UncertainInput uncertain_fabric(const estimate::Question& q, double deviation,
                                                 bool assumed) {
  return {.input = "fabric", .deviation = deviation, .assumed = assumed, .moved = [q](double change) {
            estimate::Question moved = q;
            moved.state.fabric_anisotropy += change;
            return moved;
          }};
}

} // namespace granum::test
