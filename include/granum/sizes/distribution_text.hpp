// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include <granum/sizes/distribution.hpp>

namespace granum::sizes {

/// The distribution that a text names, as command lines and scenes write it; Distribution::text() writes it
/// back.
///   equal
///   bidisperse:RATIO[:SHARE]          large over small radius, share of large grains by number (0.5)
///   uniform:SMALLEST:LARGEST          radii, in any unit, by number
///   lognormal:SIGMA[:SIZE_RATIO]      of ln r, by number
///   power-law:EXPONENT:SIZE_RATIO     density r^-EXPONENT by number
///   uniformity:C_U[:SIZE_RATIO]       lognormal by mass with d60/d10 = C_U
///   sieve:D=PASSING:D=PASSING...      d with its unit, passing 0 to 1 or with %
/// \throws   InvalidArgument for another text, listing these forms, and as the maker of the distribution
/// Checked by tests/sizes/test_distribution_text.cpp
[[nodiscard]] Distribution parse_distribution(std::string_view text);

/// The forms that parse_distribution knows, ", " between them, for messages and help.
[[nodiscard]] std::string distribution_forms();

} // namespace granum::sizes
