// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/core/utf8.hpp>

#include <algorithm>
#include <iterator>
#include <utility>

namespace granum {

std::size_t utf8_length(std::string_view text) {
  if (text.empty())
    return 0;
  const auto byte = [text](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const unsigned char first = byte(0);
  const std::size_t length = first < 0x80                    ? 1
                             : first >= 0xC2 && first < 0xE0 ? 2
                             : first >= 0xE0 && first < 0xF0 ? 3
                             : first >= 0xF0 && first < 0xF5 ? 4
                                                             : 0;
  if (length > text.size())
    return 0;
  for (std::size_t k = 1; k < length; ++k)
    if (byte(k) < 0x80 || byte(k) > 0xBF)
      return 0;
  if (length > 2) {
    // overlong forms, surrogates, beyond U+10FFFF, U+FFFE and U+FFFF
    const unsigned char second = byte(1);
    const bool refused = (first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F) ||
                         (first == 0xEF && second == 0xBF && byte(2) >= 0xBE) ||
                         (first == 0xF0 && second < 0x90) || (first == 0xF4 && second > 0x8F);
    return refused ? 0 : length;
  }
  return length;
}

namespace {

/// The number of a character of UTF-8.
char32_t code_point(std::string_view character) {
  const auto first = static_cast<unsigned char>(character[0]);
  char32_t code = character.size() == 1 ? first : first & (0x7FU >> character.size());
  for (const char c : character.substr(1))
    code = code << 6 | (static_cast<unsigned char>(c) & 0x3FU);
  return code;
}

/// Characters that control a terminal or are invisible: control characters, characters that change the
/// direction of text or end its line, and marks without width. The joiners U+200C and U+200D stay: some
/// scripts are written with them.
bool is_hidden(char32_t code) {
  constexpr std::pair<char32_t, char32_t> hidden[] = {
      {0x00, 0x08},     {0x0B, 0x1F},     {0x7F, 0x9F},      {0xAD, 0xAD},     {0x61C, 0x61C},
      {0x180E, 0x180E}, {0x200B, 0x200B}, {0x200E, 0x200F},  {0x2028, 0x202E}, {0x2060, 0x206F},
      {0xFEFF, 0xFEFF}, {0xFFF9, 0xFFFB}, {0xE0000, 0xE007F}};
  return std::any_of(std::begin(hidden), std::end(hidden),
                     [code](const auto& range) { return code >= range.first && code <= range.second; });
}

/// The text with what `escaped` makes of each hidden character.
template <class Escaped>
std::string with_hidden(std::string_view text, const Escaped& escaped) {
  std::string shown;
  while (!text.empty()) {
    const std::size_t taken = std::max<std::size_t>(utf8_length(text), 1);
    const std::string_view character = text.substr(0, taken);
    // a byte that is no UTF-8 is a character of an encoding of one byte
    if (is_hidden(code_point(character)) && character != "\xAD")
      shown += escaped(character);
    else
      shown += character;
    text.remove_prefix(taken);
  }
  return shown;
}

constexpr const char* digits = "0123456789abcdef";

} // namespace

std::string printable(std::string_view text) {
  return with_hidden(text, [](std::string_view character) {
    std::string bytes;
    for (const char c : character) {
      const auto value = static_cast<unsigned char>(c);
      bytes += {'\\', 'x', digits[value / 16], digits[value % 16]};
    }
    return bytes;
  });
}

std::string printable_json(std::string_view json) {
  return with_hidden(json, [](std::string_view character) {
    const char32_t code = code_point(character);
    const auto unit = [](char32_t of) {
      return std::string{'\\',           'u', digits[of >> 12], digits[of >> 8 & 15], digits[of >> 4 & 15],
                         digits[of & 15]};
    };
    return code < 0x10000 ? unit(code)
                          : unit(0xD7C0 + (code >> 10)) + unit(0xDC00 + (code & 0x3FF)); // a pair of UTF-16
  });
}

} // namespace granum
