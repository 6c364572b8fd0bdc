// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/io/svg_text.hpp>

#include <charconv>

namespace granum::io {

namespace {

/// Bytes of the character at the beginning of a text, 0 if they are no UTF-8.
std::size_t character_length(std::string_view text) {
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

std::string attribute_text(const SvgAttributes& attributes) {
  std::string text;
  for (const auto& [name, value] : attributes)
    text += " " + std::string(name) + "=\"" + svg_escaped(value) + "\"";
  return text;
}

} // namespace

std::string svg_number(double value) {
  char buffer[400];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, 2).ptr;
  return {buffer, end};
}

std::string svg_escaped(std::string_view text) {
  std::string escaped;
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    const char c = text[0];
    if (c == '&')
      escaped += "&amp;";
    else if (c == '<')
      escaped += "&lt;";
    else if (c == '>')
      escaped += "&gt;";
    else if (c == '"')
      escaped += "&quot;";
    else if (length == 0 || (length == 1 && static_cast<unsigned char>(c) < 0x20))
      escaped += '?';
    else
      escaped += text.substr(0, length);
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return escaped;
}

std::string svg_element(std::string_view name, const SvgAttributes& attributes) {
  return "<" + std::string(name) + attribute_text(attributes) + "/>\n";
}

std::string svg_text(std::string_view text_class, const SvgAttributes& attributes, std::string_view content) {
  if (content.empty())
    return "";
  return "<text class=\"" + std::string(text_class) + "\"" + attribute_text(attributes) + ">" +
         std::string(content) + "</text>\n";
}

std::string svg_group(const SvgAttributes& attributes, std::string_view content) {
  if (content.empty())
    return "";
  return "<g" + attribute_text(attributes) + ">\n" + std::string(content) + "</g>\n";
}

} // namespace granum::io
