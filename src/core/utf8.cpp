// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/core/utf8.hpp>

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

std::string printable(std::string_view text) {
  constexpr const char* digits = "0123456789abcdef";
  std::string shown;
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    const auto byte = static_cast<unsigned char>(text[0]);
    const std::size_t taken = length == 0 ? 1 : length;
    const bool ascii_control = (byte < 0x20 && byte != '\n' && byte != '\t') || byte == 0x7F;
    // U+0080 to U+009F, as UTF-8 or, in encodings of one byte, as they are
    const bool upper_control = (length == 0 && byte >= 0x80 && byte < 0xA0) ||
                               (byte == 0xC2 && length == 2 && static_cast<unsigned char>(text[1]) < 0xA0);
    for (const char c : text.substr(0, taken)) {
      const auto value = static_cast<unsigned char>(c);
      if (ascii_control || upper_control)
        shown += {'\\', 'x', digits[value / 16], digits[value % 16]};
      else
        shown += c;
    }
    text.remove_prefix(taken);
  }
  return shown;
}

} // namespace granum
