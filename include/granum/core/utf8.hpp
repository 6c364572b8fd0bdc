// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// Text of unknown origin: names and headings of files may contain any bytes.
/// Checked by tests/core/test_utf8.cpp
namespace granum {

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

} // namespace granum
