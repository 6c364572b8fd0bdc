// SPDX-License-Identifier: GPL-3.0-or-later
// Roots and powers of positive numbers without branches, tables or calls, so that loops over them become
// vector code. Every fused operation is written out: the bits do not depend on what the compiler may fuse.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace granum::effective::vector_math {

/// 2^52: added to a whole number below it, puts the number into the low bits of the mantissa.
constexpr double two_52 = 4503599627370496.0;
constexpr std::uint64_t bits_of_two_52 = 0x4330000000000000;

/// The whole number below 2^52 as a double.
[[gnu::always_inline]] inline double as_double(std::uint64_t whole) {
  return std::bit_cast<double>(whole | bits_of_two_52) - two_52;
}

/// Cube root of 0 or a normal positive number, within 1 ulp. The bits of x over -3 are within 5 % of
/// x^(-1/3); one step of fourth order and one of second make that 2e-9, and a Newton step on the root itself
/// squares it.
[[gnu::always_inline]] inline double cube_root(double x) {
  constexpr double top = 1099511627776.0; // 2^40: the mantissa without its 12 last bits
  const double bits = as_double(std::bit_cast<std::uint64_t>(x) >> 12);
  const double guess = std::fma(bits, -1.0 / 3, (1023.0 * 4 / 3 - 0.05) * top);
  double r = std::bit_cast<double>(std::bit_cast<std::uint64_t>(guess + two_52) << 12);
  const double h = std::fma(-x * r, r * r, 1.0); // 1 - x r^3
  r = std::fma(r * h, std::fma(h, std::fma(h, 14.0 / 81, 2.0 / 9), 1.0 / 3), r);
  const double h2 = std::fma(-x * r, r * r, 1.0);
  r = std::fma(r * h2, 1.0 / 3, r);
  const double r2 = r * r;
  const double y = x * r2;
  return std::fma(std::fma(y * y, y, -x), r2 * (-1.0 / 3), y);
}

/// An exponent in [0, 1/2] for power(): high has 40 bits, its product with an exponent of two is exact.
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
[[gnu::always_inline]] inline double log2_near_one(double m) {
  const double s = (m - 1) / (m + 1);
  const double t = s * s;
  double sum = 1.0 / 23;
#pragma GCC unroll 16
  for (int n = 21; n >= 1; n -= 2)
    sum = std::fma(sum, t, 1.0 / n);
  constexpr double two_over_ln2 = 2.8853900817779268147;
  return s * sum * two_over_ln2;
}

/// 2^r for |r| <= 1/2 and a little more, within 1 ulp: the exponential series.
[[gnu::always_inline]] inline double exp2_near_zero(double r) {
  constexpr double ln2 = 0.69314718055994530942;
  const double x = r * ln2;
  double sum = 1.0;
#pragma GCC unroll 16
  for (int n = 14; n >= 1; --n)
    sum = std::fma(sum * (1.0 / n), x, 1.0);
  return sum;
}

/// x^b for a normal positive x and 0 <= b <= 1/2, within 4 ulp; some finite number for other x.
[[gnu::always_inline]] inline double power(double x, const Exponent& b) {
  constexpr std::uint64_t root_half = 0x3fe6a09e667f3bcd, one = 0x3ff0000000000000;
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
  const std::uint64_t biased = (bits + (one - root_half)) >> 52; // exponent of two plus 1023
  const double m = std::bit_cast<double>(bits - (biased << 52) + one);
  const double k = as_double(biased) - 1023.0;
  const double small = std::fma(k, b.low, b.whole * log2_near_one(m));
  constexpr double rounder = 1.5 * two_52;
  const double shifted = std::fma(k, b.high, small) + rounder;
  const double whole = shifted - rounder;
  const double scale = std::bit_cast<double>((std::bit_cast<std::uint64_t>(shifted) << 52) + one);
  return scale * exp2_near_zero(std::fma(k, b.high, -whole) + small);
}

} // namespace granum::effective::vector_math
