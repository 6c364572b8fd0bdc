// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "harness.hpp"

/// Averages over directions in 50-digit arithmetic, and the stiffness that belongs to them.
namespace accuracy {

/// Means over E(gamma; a) of w, w x^2, w x^4, x = cos gamma.
struct Moments {
  Real m0, m2, m4;
};

/// w = 1.
Moments fabric_moments(const Real& a);
/// w = (h (1-x^2) + x^2)^b, by double-exponential quadrature.
Moments weighted_moments(const Real& a, const Real& h, const Real& b);

/// The five constants.
struct Five {
  Real C11, C33, C12, C13, C44;
};

/// Uniform strain: scale <w ((1-r) nnnn + r/4 (...))>.
Five strain_stiffness(const Real& scale, const Real& r, const Moments& w);
/// The same with the mean spin w of the grains free: C44 is the least over w of the energy of a strain e13.
Five free_spin_stiffness(const Real& scale, const Real& r, const Moments& w);
/// Uniform stress: the inverse of the compliance <w (f_n^2 + f_t^2/r)>/scale with f = F^-1 n; w = 1/k.
Five stress_stiffness(const Real& scale, const Real& r, const Moments& fabric, const Moments& w);

} // namespace accuracy
