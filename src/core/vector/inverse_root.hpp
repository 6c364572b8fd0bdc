// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src.
#pragma once

#include <bit>
#include <cstdint>

#include "level.hpp"

namespace granum {

/// x^(-1/2) of a normal positive number within 8e-7 of itself. For 0 a finite number.
template <VectorLevel level>
GRANUM_INLINE double near_inverse_root(double x) {
  constexpr std::uint64_t three_halves_of_one = 0x5fe6e31fa0cbbed5; // of the bits of 1, and a little
  const double guess = std::bit_cast<double>(three_halves_of_one - (std::bit_cast<std::uint64_t>(x) >> 1));
  // 1 - x guess^2 is between -0.0658 and 0.0696; (1-h)^(-1/2) at the Chebyshev nodes there, to 7.5e-7.
  const double h = fused<level>(-x * guess, guess, 1);
  double near = fused<level>(h, 0.3157070333634314, 0.3762547235316294);
  near = fused<level>(h, near, 0.499994602350549);
  return guess * fused<level>(h, near, 0.9999992801116374);
}

/// The same within 2 ulp, from that: a loop that is long already may leave one of the two to another.
template <VectorLevel level>
GRANUM_INLINE double nearer_inverse_root(double x, double near) {
  const double rest = fused<level>(-x * near, near, 1);
  return fused<level>(near, rest * fused<level>(0.375, rest, 0.5), near);
}

/// x^(-1/2) of a normal positive number within 2 ulp, without root and quotient, which are slower than
/// all the rest of a contact law. For 0 a finite number.
/// Checked by tests/core/vector/test_inverse_root.cpp
template <VectorLevel level>
GRANUM_INLINE double inverse_root(double x) {
  return nearer_inverse_root<level>(x, near_inverse_root<level>(x));
}

} // namespace granum
