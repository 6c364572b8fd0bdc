// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src. The power of math.hpp with fused operations only where the level
// has them, and for exponents up to 1.
#pragma once

#include <bit>
#include <cstdint>

#include "level.hpp"

namespace granum {

/// b in [0, 1]; high has 40 bits, its product with an exponent of two is exact.
struct SplitExponent {
  double whole, high, low;

  explicit SplitExponent(double b)
      : whole(b), high(std::bit_cast<double>(std::bit_cast<std::uint64_t>(b) >> 13 << 13)), low(b - high) {}
};

/// log2(m) for m in [sqrt(1/2), sqrt(2)]: 2/ln 2 artanh((m-1)/(m+1)).
template <VectorLevel level>
GRANUM_INLINE double plain_log2_near_one(double m) {
  const double s = (m - 1) / (m + 1);
  const double t = s * s;
  double sum = 1.0 / 19;
#pragma GCC unroll 16
  for (int n = 17; n >= 1; n -= 2)
    sum = fused<level>(sum, t, 1.0 / n);
  constexpr double two_over_ln2 = 2.8853900817779268147;
  return s * sum * two_over_ln2;
}

/// 2^r for |r| <= 1/2 and a little more: the exponential series, 1 + x (1 + x/2 (1 + x/3 (...))).
template <VectorLevel level>
GRANUM_INLINE double plain_exp2_near_zero(double r) {
  const double x = r * 0.69314718055994530942; // ln 2
  double sum = 1;
#pragma GCC unroll 16
  for (int n = 13; n >= 1; --n)
    sum = fused<level>(x * (1.0 / n), sum, 1);
  return sum;
}

/// x^b of a normal positive number within 2.5 ulp as vector code. For 0 a small number.
/// Checked by tests/core/vector/test_power.cpp
template <VectorLevel level>
GRANUM_INLINE double vector_power(double x, const SplitExponent& b) {
  constexpr std::uint64_t root_half = 0x3fe6a09e667f3bcd, one = 0x3ff0000000000000;
  constexpr double two_52 = 0x1p52; // in whose last bits small whole numbers stand
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
  const std::uint64_t biased = (bits + (one - root_half)) >> 52; // exponent of two plus 1023
  const double part = plain_log2_near_one<level>(std::bit_cast<double>(bits - (biased << 52) + one));
  const double whole = std::bit_cast<double>(biased | std::bit_cast<std::uint64_t>(two_52)) - (two_52 + 1023);
  const double small = fused<level>(b.whole, part, whole * b.low);
  const double large = whole * b.high; // exact: 11 bits times 40
  constexpr double rounder = 1.5 * two_52;
  const double shifted = (large + small) + rounder;
  const double scale = std::bit_cast<double>((std::bit_cast<std::uint64_t>(shifted) << 52) + one);
  return scale * plain_exp2_near_zero<level>((large - (shifted - rounder)) + small);
}

} // namespace granum
