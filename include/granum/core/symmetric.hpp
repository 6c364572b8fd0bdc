// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include <granum/core/check.hpp>
#include <granum/core/error.hpp>

/// Checked by tests/elastic/test_mandel.cpp and tests/fabric/test_measures.cpp
namespace granum {

/// How far two entries that should be equal may differ, over the largest entry. A solver leaves less than
/// 1e-6, and two halves rounded to four digits, each by itself, differ by 1e-3 at most. A matrix in
/// which one half was left out is far above, unless that half does not matter.
inline constexpr double largest_asymmetry = 1e-3;

/// Any finite, symmetric matrix.
/// \throws   InvalidArgument for entries that are not finite, or differ by more than largest_asymmetry
template <int size, class Matrix>
void require_symmetric(const char* name, const Matrix& matrix) {
  double largest = 0, difference = 0;
  int row = 0, column = 0;
  for (int i = 0; i < size; ++i)
    for (int j = 0; j <= i; ++j) {
      const double below = require_finite(name, matrix(i, j)), above = require_finite(name, matrix(j, i));
      largest = std::max({largest, std::abs(below), std::abs(above)});
      if (const double d = std::abs(below - above); d > difference) {
        difference = d;
        row = i + 1;
        column = j + 1;
      }
    }
  if (difference > largest_asymmetry * largest)
    throw InvalidArgument(std::string(name) + " is not symmetric: entries " + std::to_string(row) +
                          std::to_string(column) + " and " + std::to_string(column) + std::to_string(row) +
                          " differ by more than rounding");
}

} // namespace granum
