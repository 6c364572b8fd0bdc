// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src. Cube roots of positive numbers as vector code, without branches, tables or calls. Every
// fused operation is written out: the bits do not depend on the compiler's choice of fused operations.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "as_double.hpp"
#include "level.hpp"

namespace granum {

/// Cube root of 0 or a normal positive number, within 1 ulp, in three steps. Loops over long blocks run each
/// step over the whole block: a chain of all three is too long for a processor to keep several in flight.
///
/// r near x^(-1/3), |1 - x r^3| <= 0.1021: the bits of x over -3.
GRANUM_INLINE double inverse_cube_root_guess(double x) {
  constexpr double top = 1099511627776.0; // 2^40: the mantissa without its 12 last bits
  const double bits = as_double(std::bit_cast<std::uint64_t>(x) >> 12);
  const double guess = std::fma(bits, -1.0 / 3, (1023.0 * 4 / 3 - 0.068) * top);
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(guess + two_52) << 12);
}

/// r to 4e-10: (1-h)^(-1/3) = 1 + h q(h), q interpolated at the Chebyshev nodes of |h| <= 0.1021.
GRANUM_INLINE double inverse_cube_root_step(double x, double r) {
  const double h = std::fma(-(x * r), r * r, 1.0); // 1 - x r^3
  double q = 0.11265994048729445;
  q = std::fma(q, h, 0.12641728729454452);
  q = std::fma(q, h, 0.14402400562087128);
  q = std::fma(q, h, 0.17283326382837919);
  q = std::fma(q, h, 0.22222223388199822);
  q = std::fma(q, h, 0.33333333696064593);
  return std::fma(r * h, q, r);
}

/// The root from r by a Newton step, which squares the error.
GRANUM_INLINE double cube_root_from(double x, double r) {
  const double r2 = r * r;
  const double y = x * r2;
  return std::fma(std::fma(y * y, y, -x), r2 * (-1.0 / 3), y);
}

} // namespace granum
