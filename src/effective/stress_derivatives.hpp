// SPDX-License-Identifier: GPL-3.0-or-later
// Constants and moduli with their derivatives by the logarithms of the two stresses.
#pragma once

#include <cmath>

#include <Eigen/Core>
#include <unsupported/Eigen/AutoDiff>

#include <granum/core/error.hpp>
#include <granum/effective/exponents.hpp>

#include "kernels.hpp"

namespace granum::effective::kernel {

/// A number with its derivatives by ln stress_v and ln stress_h.
using Dual = Eigen::AutoDiffScalar<Eigen::Vector2d>;

inline Dual power(const Dual& x, double exponent) {
  const double value = std::exp(exponent * std::log(x.value()));
  return {value, x.derivatives() * (value * exponent / x.value())};
}

/// A modulus of five constants, with its derivatives.
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

/// Requirements of derivatives besides a valid state: stress and contacts, and k_t > 0 for a Young's modulus
/// of uniform stress.
/// \throws   InvalidArgument otherwise
void require_differentiable(const State& state, Hypothesis hypothesis, Modulus which);

/// The stiffness of a model with its derivatives. Assumes a checked, loaded state.
Constants<Dual> stress_derivatives(const State& state, const Model& model);
/// Whether a modulus of a stiffness is zero apart from rounding. Where C44 is small it is a sum of small
/// terms; all others are differences of larger terms.
inline bool vanishes(double value, double C11, Modulus which) {
  return std::abs(value) <= (which == Modulus::G_vh ? 0 : 1e-13 * C11);
}
/// \throws   InvalidArgument where the modulus vanishes: it has no exponents
void require_modulus(double value, double C11, Modulus which);
/// Exponents of a modulus of these constants.
/// \throws   InvalidArgument as require_modulus, for a Young's modulus of a stiffness that is not positive
///           definite, and where the stiffness exceeds the range of a double
StressExponents exponents_of(const Constants<Dual>& constants, Modulus which);

} // namespace granum::effective::kernel
