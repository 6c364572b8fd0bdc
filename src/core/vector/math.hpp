// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src. Roots and powers of positive numbers without branches, tables or calls, so that loops over
// them become vector code. Every fused operation is written out: the bits do not depend on what the compiler
// may fuse.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "level.hpp"

namespace granum::vector_math {

/// 2^52: added to a whole number below it, puts the number into the low bits of the mantissa.
constexpr double two_52 = 4503599627370496.0;
constexpr std::uint64_t bits_of_two_52 = 0x4330000000000000;

/// The whole number below 2^52 as a double.
GRANUM_INLINE double as_double(std::uint64_t whole) {
  return std::bit_cast<double>(whole | bits_of_two_52) - two_52;
}

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

/// An exponent in [0, 1/2] for power_from(): high has 40 bits, its product with an exponent of two is exact.
struct Exponent {
  double whole;
  double high;
  double low;
};

inline Exponent exponent(double b) {
  const double high = std::bit_cast<double>(std::bit_cast<std::uint64_t>(b) & ~std::uint64_t{0x1fff});
  return {b, high, b - high};
}

/// log2(m) for m in [sqrt(1/2), sqrt(2)], absolute error below 2e-16: 2/ln 2 artanh((m-1)/(m+1)).
GRANUM_INLINE double log2_near_one(double m) {
  const double s = (m - 1) / (m + 1);
  const double t = s * s;
  double sum = 1.0 / 19;
#pragma GCC unroll 16
  for (int n = 17; n >= 1; n -= 2)
    sum = std::fma(sum, t, 1.0 / n);
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
GRANUM_INLINE double exp2_near_zero(double r) {
  const double x = r * 0.69314718055994530942; // ln 2
  double sum = inverse_factorials.back();
#pragma GCC unroll 16
  for (std::size_t n = inverse_factorials.size() - 1; n-- > 0;)
    sum = std::fma(sum, x, inverse_factorials[n]);
  return sum;
}

/// log2 of x = 2^whole m.
struct Log2 {
  double whole; ///< whole number
  double part;  ///< log2 m, |part| <= 1/2
};

/// log2 of a normal positive number; some finite number for other x.
GRANUM_INLINE Log2 log2_of(double x) {
  constexpr std::uint64_t root_half = 0x3fe6a09e667f3bcd, one = 0x3ff0000000000000;
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
  const std::uint64_t biased = (bits + (one - root_half)) >> 52; // exponent of two plus 1023
  const double m = std::bit_cast<double>(bits - (biased << 52) + one);
  return {as_double(biased) - 1023.0, log2_near_one(m)};
}

/// x^b from log2 x, within 1.5 ulp, for 0 <= b <= 1/2.
GRANUM_INLINE double power_from(const Log2& x, const Exponent& b) {
  constexpr std::uint64_t one = 0x3ff0000000000000;
  const double small = std::fma(x.whole, b.low, b.whole * x.part);
  constexpr double rounder = 1.5 * two_52;
  const double shifted = std::fma(x.whole, b.high, small) + rounder;
  const double whole = shifted - rounder;
  const double scale = std::bit_cast<double>((std::bit_cast<std::uint64_t>(shifted) << 52) + one);
  return scale * exp2_near_zero(std::fma(x.whole, b.high, -whole) + small);
}

} // namespace granum::vector_math
