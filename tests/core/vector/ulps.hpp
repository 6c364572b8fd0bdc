// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>

namespace granum::test {

/// Error of `value` in units of the last place of the exact number, which long double knows 11 bits better.
inline double ulps(double value, long double exact) {
  const double nearest = static_cast<double>(exact);
  const double place = std::nextafter(nearest, std::numeric_limits<double>::infinity()) - nearest;
  return static_cast<double>(std::abs(static_cast<long double>(value) - exact) /
                             static_cast<long double>(place));
}

} // namespace granum::test
