// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/dem. The power of effective/vector_math.hpp without fused operations, which machines without
// them would have to imitate, and for exponents up to 1.
#pragma once

#include <bit>
#include <cstdint>

#include "../effective/vector_math.hpp"
#include "vector_level.hpp"

namespace granum::dem {

/// log2(m) for m in [sqrt(1/2), sqrt(2)]: 2/ln 2 artanh((m-1)/(m+1)).
GRANUM_INLINE double plain_log2_near_one(double m) {
  const double s = (m - 1) / (m + 1);
  const double t = s * s;
  double sum = 1.0 / 19;
#pragma GCC unroll 16
  for (int n = 17; n >= 1; n -= 2)
    sum = sum * t + 1.0 / n;
  constexpr double two_over_ln2 = 2.8853900817779268147;
  return s * sum * two_over_ln2;
}

/// 2^r for |r| <= 1/2 and a little more: the exponential series.
GRANUM_INLINE double plain_exp2_near_zero(double r) {
  namespace vm = effective::vector_math;
  const double x = r * 0.69314718055994530942; // ln 2
  double sum = vm::inverse_factorials.back();
#pragma GCC unroll 16
  for (std::size_t n = vm::inverse_factorials.size() - 1; n-- > 0;)
    sum = sum * x + vm::inverse_factorials[n];
  return sum;
}

/// x^b of a normal positive number within 2.5 ulp, for 0 <= b <= 1, as vector code with the same bits at
/// every level. For 0 a small number.
/// Checked by tests/dem/test_vector_power.cpp
GRANUM_INLINE double vector_power(double x, const effective::vector_math::Exponent& b) {
  namespace vm = effective::vector_math;
  constexpr std::uint64_t root_half = 0x3fe6a09e667f3bcd, one = 0x3ff0000000000000;
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
  const std::uint64_t biased = (bits + (one - root_half)) >> 52; // exponent of two plus 1023
  const double part = plain_log2_near_one(std::bit_cast<double>(bits - (biased << 52) + one));
  const double whole = vm::as_double(biased) - 1023.0;
  const double small = whole * b.low + b.whole * part;
  const double large = whole * b.high; // exact: 11 bits times 40
  constexpr double rounder = 1.5 * vm::two_52;
  const double shifted = (large + small) + rounder;
  const double scale = std::bit_cast<double>((std::bit_cast<std::uint64_t>(shifted) << 52) + one);
  return scale * plain_exp2_near_zero((large - (shifted - rounder)) + small);
}

} // namespace granum::dem
