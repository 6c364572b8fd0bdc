// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/plot/svg_text.hpp>

#include <charconv>

#include <granum/core/utf8.hpp>

namespace granum::plot {

namespace {

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
    const std::size_t length = utf8_length(text);
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

} // namespace granum::plot
