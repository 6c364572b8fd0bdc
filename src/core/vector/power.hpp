// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src. Roots and powers of positive numbers as vector code, without branches, tables or calls. The
// level says whether products and sums are fused; `always_fused` gives the same bits at every level, by a
// call where there is no instruction.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "level.hpp"

namespace granum {

constexpr VectorLevel always_fused = VectorLevel::avx2;

/// 2^52: added to a whole number below it, puts the number into the low bits of the mantissa.
constexpr double two_52 = 4503599627370496.0;

/// The whole number below 2^52 as a double, without the conversion that AVX2 has no instruction for.
GRANUM_INLINE double as_double(std::uint64_t whole) {
  return std::bit_cast<double>(whole | std::bit_cast<std::uint64_t>(two_52)) - two_52;
}

/// Cube root of 0 or a normal positive number, within 1 ulp, in three steps. Loops over long blocks run each
/// step over the whole block: a chain of all three is too long for a processor to keep several in flight.
/// Every fused operation is written out: the bits do not depend on the compiler's choice of fused operations.
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
