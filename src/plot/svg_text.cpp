// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/plot/svg_text.hpp>

#include <cctype>
#include <charconv>
#include <string>

#include <granum/core/text.hpp>

namespace granum::plot {

namespace {

std::string attribute_text(const SvgAttributes& attributes) {
  std::string text;
  for (const auto& [name, value] : attributes)
    text += " " + std::string(name) + "=\"" + svg_escaped(value) + "\"";
  return text;
}

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

struct PrintedSign {
  std::string_view typed;
  std::string_view printed;
};
constexpr PrintedSign printed_signs_table[] = {{"+-", "\u00b1"},        {"<=", "\u2264"},
                                               {">=", "\u2265"},        {"alpha", "\u03b1"},
                                               {"sigma_v", "\u03c3_v"}, {"sigma_h", "\u03c3_h"}};

} // namespace

std::string printed_signs(std::string_view text) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    std::string_view put = text.substr(at, 1);
    std::size_t length = 1;
    for (const PrintedSign& sign : printed_signs_table) {
      const std::size_t end = at + sign.typed.size();
      if (!text.substr(at).starts_with(sign.typed))
        continue;
      const bool within = is_word(sign.typed.front()) &&
                          ((at > 0 && is_word(text[at - 1])) || (end < text.size() && is_word(text[end])));
      if (!within) {
        put = sign.printed;
        length = sign.typed.size();
      }
    }
    out += put;
    at += length;
  }
  return out;
}

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
