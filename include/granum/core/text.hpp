// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

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

/// \file
/// Text of unknown origin: names and headings of files may contain any bytes.
/// Checked by tests/core/test_utf8.cpp

/// Bytes of the character that `text` begins with, 1 to 4; 0 if they are no UTF-8, are U+FFFE or U+FFFF, or
/// there are none.
[[nodiscard]] std::size_t utf8_length(std::string_view text);

/// `text` for a terminal: control characters, which could move its cursor or worse, and characters that turn
/// the direction of text or are not seen (U+202E, U+200B) become a backslash, an x and two digits a byte.
/// Line ends and tabs stay, and so do bytes that are no UTF-8 but letters in other encodings.
[[nodiscard]] std::string printable(std::string_view text);

/// JSON for a terminal: its strings have escapes (a backslash, u and four digits) for these characters, so
/// that a reader of JSON finds the same text.
/// Assumes   valid UTF-8, with control characters below U+0020 escaped already
[[nodiscard]] std::string printable_json(std::string_view json);

/// \file
/// Which known word was meant by one that is not known. Checked by tests/core/test_near_miss.cpp

/// How many letters are wrong, missing, too many, or two neighbours the wrong way round: the least number of
/// such slips that make `a` of `b` (optimal string alignment).
[[nodiscard]] std::size_t slips_between(std::string_view a, std::string_view b);

/// Whether two words differ at most in case, and in a blank, _ or - between their parts.
[[nodiscard]] bool same_word(std::string_view a, std::string_view b);

/// The known words that `word` may have been meant for, in their order. The first of these rules that finds
/// any: the same word; of three letters or more, those that begin with it,
/// those that it begins with, those whose last part behind a point or hyphen it is; those with the
/// fewest slips, one for two to five letters and one more for every four.
[[nodiscard]] std::vector<std::string> near_misses(std::string_view word, std::span<const std::string> known);

/// "; did you mean sphere?" or "; did you mean stress-v or stress-h?" for error messages; empty if no known
/// word is near, or more than three are.
[[nodiscard]] std::string did_you_mean(std::string_view word, std::span<const std::string> known);

/// "sand 'toyura' is unknown; did you mean toyoura?", or the list of the known words where none is near.
[[nodiscard]] std::string unknown_word(std::string_view kind, std::string_view word,
                                       std::span<const std::string> known);

} // namespace granum
