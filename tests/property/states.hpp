// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>
#include <ostream>

#include <rapidcheck.h>

#include <granum/core/text.hpp>
#include <granum/effective/state.hpp>

/// Random packings over the whole domain of the closed forms. rapidcheck shrinks a packing that breaks a
/// property towards the first values of the ranges.
namespace granum::test {

/// A whole number of steps from low to high, so that shrinking ends at low.
inline double between(double low, double high) {
  constexpr int steps = 1 << 20;
  return low + (high - low) * *rc::gen::inRange(0, steps + 1) / steps;
}
inline double log_between(double low, double high) {
  return std::exp(between(std::log(low), std::log(high)));
}

inline contact::PowerLaw any_law(double radius) {
  const contact::GrainMaterial grain{log_between(1e6, 1e12), between(-0.999, 0.5)};
  switch (*rc::gen::inRange(0, 4)) {
  case 0:
    return contact::PowerLaw::sphere(grain, radius);
  case 1:
    return contact::PowerLaw::cone(grain, log_between(0.01, 10));
  case 2:
    return contact::PowerLaw::flat(grain, log_between(1e-4, 0.1) * radius);
  default:
    const double alpha = between(1, 8);
    return contact::PowerLaw::general(grain, alpha, log_between(0.1, 10) * std::pow(radius, 1 - alpha));
  }
}

/// A packing whose contact forces differ by less than 1e3 with direction.
inline effective::State any_state() {
  const double radius = log_between(1e-9, 1e3);
  const double pressure = log_between(1e-3, 1e9);
  return {.law = any_law(radius),
          .tangential_ratio = between(0, 2),
          .radius = radius,
          .void_ratio = log_between(0.1, 3),
          .coordination_number = between(0.1, 14),
          .fabric_anisotropy = between(-1, 1),
          .stress_v = pressure * log_between(0.05, 20),
          .stress_h = pressure};
}

inline std::ostream& describe(std::ostream& out, const effective::State& s) {
  return out << "alpha " << short_text(s.law.power_law()->alpha()) << ", k_t/k_n "
             << exact_text(s.tangential_ratio) << ", R " << exact_text(s.radius) << ", e "
             << exact_text(s.void_ratio) << ", C_n " << exact_text(*s.coordination_number) << ", a "
             << exact_text(s.fabric_anisotropy) << ", stress_v " << exact_text(s.stress_v) << ", stress_h "
             << exact_text(s.stress_h);
}

} // namespace granum::test
