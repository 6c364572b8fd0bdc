// SPDX-License-Identifier: GPL-3.0-or-later
// Moduli of constants that carry derivatives, and what the derivatives are by.
#pragma once

#include <cmath>

#include <granum/core/error.hpp>
#include <granum/effective/sensitivity/gradients.hpp>

#include "dual.hpp"
#include "effective/kernels.hpp"

namespace granum::effective::kernel {

/// By what a Dual<N> is differentiated: the first N of these.
enum Seed { log_stress_v, log_stress_h, log_coordination, log_radius, voids, anisotropy, shape, ratio };

/// All of them: Seed::ratio is the last.
inline constexpr int all_seeds = 8;
/// The stresses alone.
inline constexpr int stress_seeds = 2;

template <int N>
Dual<N> seeded(double value, Seed seed, double slope = 1) {
  Dual<N> x(value);
  if (seed < N)
    x.derivatives()[seed] = slope;
  return x;
}
template <int N>
Dual<N> log_seeded(double value, Seed seed) {
  return seeded<N>(value, seed, value);
}

/// A modulus of five constants, with the derivatives that they carry.
template <class T>
T plain_modulus(const Constants<T>& c, Modulus which) {
  const T determinant = c.C33 * (c.C11 + c.C12) - 2 * c.C13 * c.C13;
  switch (which) {
  case Modulus::K:
    return (2 * c.C11 + c.C33 + 2 * c.C12 + 4 * c.C13) / 9;
  case Modulus::G_hh:
    return (c.C11 - c.C12) / 2;
  case Modulus::G_vh:
    return c.C44;
  case Modulus::E_v:
    return determinant / (c.C11 + c.C12);
  case Modulus::E_h:
    return 2 * determinant * (c.C11 - c.C12) / (c.C33 * (c.C11 - c.C12) + determinant);
  case Modulus::C11:
    return c.C11;
  case Modulus::C33:
    return c.C33;
  case Modulus::C12:
    return c.C12;
  case Modulus::C13:
    return c.C13;
  }
  return T(0); // not reached: the public function has refused other values
}

/// The same at any size: Young's moduli are made of products that must stay within the range of a double.
template <class T>
T modulus(const Constants<T>& c, Modulus which) {
  const double size = std::abs(c.C11.value());
  const bool young = which == Modulus::E_v || which == Modulus::E_h;
  if (!young || (size > 1e-90 && size < 1e90) || !(size > 0) || !std::isfinite(size))
    return plain_modulus(c, which);
  const int half = std::ilogb(size) / 2; // the power of two itself may be beyond the range
  const double down = std::scalbn(1.0, -half), up = std::scalbn(1.0, half);
  const auto moved = [down](const T& x) { return T(T(x * down) * down); };
  const T x = plain_modulus(Constants<T>{.C11 = moved(c.C11),
                                         .C33 = moved(c.C33),
                                         .C12 = moved(c.C12),
                                         .C13 = moved(c.C13),
                                         .C44 = moved(c.C44)},
                            which);
  return T(T(x * up) * up);
}

/// What derivatives need beyond a valid state: stress and contacts, and for a Young's modulus of uniform
/// stress k_t.
/// \throws   InvalidArgument otherwise
void require_differentiable(const State& state, Hypothesis hypothesis, Modulus which);

/// The modulus of the five plain constants [Pa].
/// \throws   InvalidArgument for a Young's modulus of a stiffness that is not positive definite, and where
///           the stiffness is beyond what a double holds
template <int N>
double checked_modulus(const Constants<Dual<N>>& c, Modulus which) {
  if (!std::isfinite(c.C11.value()) || !std::isfinite(c.C33.value()))
    throw InvalidArgument("the moduli exceed what a double can hold");
  return effective::modulus({.C11 = c.C11.value(),
                             .C33 = c.C33.value(),
                             .C12 = c.C12.value(),
                             .C13 = c.C13.value(),
                             .C44 = c.C44.value()},
                            which);
}

/// The stiffness of a model with its derivatives by the stresses alone. Assumes a checked, loaded state.
Constants<Dual<stress_seeds>> stress_derivatives(const State& state, const Model& model);
/// Whether a modulus of a stiffness is zero but for rounding. C44 is a sum of small terms where it is small;
/// all others are differences of larger ones.
inline bool vanishes(double value, double C11, Modulus which) {
  return std::abs(value) <= (which == Modulus::G_vh ? 0 : 1e-13 * C11);
}
/// \throws   InvalidArgument where the modulus vanishes: it has no exponents
void require_modulus(double value, double C11, Modulus which);
/// Exponents of a modulus of constants that carry their derivatives by the logarithms of the stresses.
/// \throws   InvalidArgument as checked_modulus and require_modulus
StressExponents exponents_of(const Constants<Dual<stress_seeds>>& constants, Modulus which);

/// The stiffness of a model with its derivatives by all seeds. Assumes a checked, loaded state.
Constants<Dual<all_seeds>> all_derivatives(const State& state, const Model& model);
/// A modulus at this state of this value and these derivatives by all seeds, with those by every Input.
Gradient by_inputs(const State& state, double value, const Dual<all_seeds>::DerType& by);

} // namespace granum::effective::kernel
