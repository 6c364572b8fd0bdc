// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src. Powers of positive numbers as vector code, without branches, tables or calls. The level
// says whether products and sums are fused; `always_fused` gives the same bits at every level, by a call
// where there is no instruction.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "as_double.hpp"
#include "level.hpp"

namespace granum {

constexpr VectorLevel always_fused = VectorLevel::avx2;

/// An exponent b in [0, 1]; high has 40 bits, its product with an exponent of two is exact.
struct SplitExponent {
  double whole, high, low;

  explicit SplitExponent(double b)
      : whole(b), high(std::bit_cast<double>(std::bit_cast<std::uint64_t>(b) >> 13 << 13)), low(b - high) {}
};

/// log2(m) for m in [sqrt(1/2), sqrt(2)], absolute error below 2e-16: 2/ln 2 artanh((m-1)/(m+1)).
template <VectorLevel level>
GRANUM_INLINE double log2_near_one(double m) {
  const double s = (m - 1) / (m + 1);
  const double t = s * s;
  double sum = 1.0 / 19;
#pragma GCC unroll 16
  for (int n = 17; n >= 1; n -= 2)
    sum = fused<level>(sum, t, 1.0 / n);
  constexpr double two_over_ln2 = 2.8853900817779268147;
  return s * sum * two_over_ln2;
}

/// 1/n! for n up to 13.
constexpr std::array<double, 14> inverse_factorials = [] {
  std::array<double, 14> inverse{1.0};
  double factorial = 1;
  for (std::size_t n = 1; n < inverse.size(); ++n)
    inverse[n] = 1 / (factorial *= static_cast<double>(n));
  return inverse;
}();

/// 2^r for |r| <= 1/2 and a little more, within 1 ulp: the exponential series.
template <VectorLevel level>
GRANUM_INLINE double exp2_near_zero(double r) {
  const double x = r * 0.69314718055994530942; // ln 2
  double sum = inverse_factorials[13];
#pragma GCC unroll 16
  for (int n = 12; n >= 0; --n)
    sum = fused<level>(sum, x, inverse_factorials[static_cast<std::size_t>(n)]);
  return sum;
}

/// log2 of x = 2^whole m.
struct Log2 {
  double whole; ///< whole number
  double part;  ///< log2 m, |part| <= 1/2
};

/// log2 of a normal positive number; some finite number for other x.
template <VectorLevel level>
GRANUM_INLINE Log2 log2_of(double x) {
  constexpr std::uint64_t root_half = 0x3fe6a09e667f3bcd, one = 0x3ff0000000000000;
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
  const std::uint64_t biased = (bits + (one - root_half)) >> 52; // exponent of two plus 1023
  const double m = std::bit_cast<double>(bits - (biased << 52) + one);
  return {as_double(biased) - 1023.0, log2_near_one<level>(m)};
}

/// x^b from log2 x, within 1.5 ulp for b up to 1/2 and 2.5 ulp up to 1.
/// For x = 0 a small number.
/// Checked by tests/core/vector/test_power.cpp
template <VectorLevel level>
GRANUM_INLINE double power_from(const Log2& x, const SplitExponent& b) {
  constexpr std::uint64_t one = 0x3ff0000000000000;
  const double small = fused<level>(x.whole, b.low, b.whole * x.part);
  constexpr double rounder = 1.5 * two_52;
  const double shifted = fused<level>(x.whole, b.high, small) + rounder;
  const double whole = shifted - rounder;
  const double scale = std::bit_cast<double>((std::bit_cast<std::uint64_t>(shifted) << 52) + one);
  return scale * exp2_near_zero<level>(fused<level>(x.whole, b.high, -whole) + small);
}

} // namespace granum
