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

} // namespace

std::string printable(std::string_view text) {
  constexpr const char* digits = "0123456789abcdef";
  std::string shown;
  while (!text.empty()) {
    const std::size_t taken = std::max<std::size_t>(utf8_length(text), 1);
    // a byte that is no UTF-8 is a character of an encoding of one byte
    const bool hidden = is_hidden(code_point(text.substr(0, taken))) && text[0] != '\xAD';
    for (const char c : text.substr(0, taken)) {
      const auto value = static_cast<unsigned char>(c);
      if (hidden)
        shown += {'\\', 'x', digits[value / 16], digits[value % 16]};
      else
        shown += c;
    }
    text.remove_prefix(taken);
  }
  return shown;
}

} // namespace granum
