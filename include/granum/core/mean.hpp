// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace granum {

/// 2 a b/(a + b) of two positive numbers, not checked; exactly a where b is a, and without overflow.
/// Accuracy  2 ulp.  Checked by tests/contact/test_pair.cpp
[[nodiscard]] constexpr double harmonic_mean(double a, double b) noexcept { return 2 * a * (b / (a + b)); }

} // namespace granum
