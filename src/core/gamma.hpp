// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src. Compiled once, because Boost's gamma functions take seconds to compile.
#pragma once

#include <cstddef>

namespace granum {

/// Gamma(z)/Gamma(z + 1/2), without the overflow of its parts.
[[nodiscard]] double gamma_ratio_half(double z);

/// Probability that chi-square of so many degrees of freedom is at least that large; 1 with no degree.
[[nodiscard]] double p_value(double chi_square, std::size_t degrees_of_freedom);

} // namespace granum
