// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src.
#pragma once

#include <bit>
#include <cstdint>

#include "level.hpp"

namespace granum {

/// 2^52: added to a whole number below it, puts the number into the low bits of the mantissa.
constexpr double two_52 = 4503599627370496.0;

/// The whole number below 2^52 as a double, without the conversion that AVX2 has no instruction for.
GRANUM_INLINE double as_double(std::uint64_t whole) {
  return std::bit_cast<double>(whole | std::bit_cast<std::uint64_t>(two_52)) - two_52;
}

} // namespace granum
