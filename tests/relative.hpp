// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <doctest/doctest.h>

/// Equality within a truly relative tolerance. doctest's own Approx adds 1 to the magnitude, so that a
/// modulus in Pa is compared relatively but a compliance in 1/Pa not at all.
inline doctest::Approx relative(double value, double tolerance) {
  return doctest::Approx(value).epsilon(tolerance).scale(0);
}
