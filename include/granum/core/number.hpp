// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

/// Numbers to text and back, the same in every locale.
/// Checked by tests/core/test_number.cpp
namespace granum {

/// A number at the beginning of a text, and the text after it.
struct LeadingNumber {
  double value = 0;
  std::string_view rest;
};

/// The decimal number that `text` begins with, after an optional sign. Nothing if there is none, if it is NaN
/// or infinite, or if its magnitude is outside of the range of a double.
[[nodiscard]] std::optional<LeadingNumber> leading_number(std::string_view text);
/// The number in `text`, which may have blanks around it and nothing else.
[[nodiscard]] std::optional<double> parse_number(std::string_view text);

/// `text` without the blanks, tabs and carriage returns around it.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// The fewest digits, up to 17, from which parse_number gives back the same bits of any finite value.
[[nodiscard]] std::string exact_text(double value);
/// At most `digits` significant digits, no trailing zeros, for people to read.
[[nodiscard]] std::string short_text(double value, int digits = 4);
/// A share as per cent, two significant digits or whole numbers: "2.7 %", "64 %", "418 %".
[[nodiscard]] std::string percent_text(double share);

namespace detail {
/// The text that printf makes of a format and its arguments, for messages; cut after 255 characters.
[[nodiscard, gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...);
} // namespace detail

} // namespace granum
