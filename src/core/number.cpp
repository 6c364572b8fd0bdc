// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/core/number.hpp>

#include <charconv>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <string>
#include <system_error>

#include <fast_float/fast_float.h>

namespace granum {

namespace {

std::string general_text(double value, int digits) {
  char buffer[64];
  const auto end =
      std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, digits).ptr;
  return {buffer, end};
}

/// Whether a decimal number that was read as 0 has other digits: its magnitude is too small for a double.
bool is_written_nonzero(std::string_view number) {
  return number.substr(0, number.find_first_of("eE")).find_first_of("123456789") != std::string_view::npos;
}

} // namespace

std::optional<LeadingNumber> leading_number(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-')
    text.remove_prefix(1);
  double value = 0;
  // Not all standard libraries have std::from_chars of a double.
  const auto [end, error] = fast_float::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || !std::isfinite(value))
    return std::nullopt;
  const std::string_view number = text.substr(0, static_cast<std::size_t>(end - text.data()));
  if (value == 0 && is_written_nonzero(number))
    return std::nullopt;
  return LeadingNumber{value, text.substr(number.size())};
}

std::optional<double> parse_number(std::string_view text) {
  const auto number = leading_number(trimmed(text));
  if (!number || !number->rest.empty())
    return std::nullopt;
  return number->value;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos)
    return {};
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

std::string exact_text(double value) {
  const double size = std::abs(value);
  const bool plain = size == 0 || (size >= 1e-4 && size < 1e16);
  char buffer[64];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value,
                                plain ? std::chars_format::fixed : std::chars_format::scientific)
                      .ptr};
}

std::string short_text(double value, int digits) { return general_text(value, digits); }

std::string percent_text(double share) {
  const double percent = 100 * share;
  const double whole = std::round(percent);
  return short_text(std::abs(percent) < 100 ? percent : whole, std::abs(percent) < 100 ? 2 : 15) + " %";
}

std::string detail::formatted(const char* format, ...) {
  char buffer[256];
  std::va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(buffer, sizeof buffer, format, arguments);
  va_end(arguments);
  return buffer;
}

} // namespace granum
