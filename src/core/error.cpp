// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/core/error.hpp>

#include <limits>
#include <optional>
#include <string>
#include <utility>

#include <granum/core/text.hpp>

namespace granum {

namespace {

std::string out_of_range_text(const std::string& name, double value, const std::string& unit,
                              const std::string& range) {
  return name + " = " + detail::refused_text(value, range, 10) + (unit.empty() ? "" : " " + unit) +
         " is outside " + range;
}

std::string with_visible_nul(std::string text) {
  for (std::size_t at = text.find('\0'); at != std::string::npos; at = text.find('\0', at))
    text.replace(at, 1, "\\x00");
  return text;
}

} // namespace

Error::Error(const std::string& text) : std::runtime_error(with_visible_nul(text)) {}

InvalidArgument::InvalidArgument(const std::string& name, double value, const std::string& unit,
                                 const std::string& range)
    : Error(out_of_range_text(name, value, unit, range)), refused_({name, value, unit, range}) {}

FileError::FileError(const std::string& path, std::size_t line, const std::string& what)
    : Error(path + (line > 0 ? ":" + std::to_string(line) : "") + ": " + what), path_(path), line_(line) {}

} // namespace granum

namespace granum::detail {

namespace {

/// Takes the number or infinity off the front of a text.
std::optional<double> take_end(std::string_view& text) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const auto& [word, value] : {std::pair("inf", infinity), std::pair("-inf", -infinity)})
    if (text.starts_with(word)) {
      text.remove_prefix(std::string_view(word).size());
      return value;
    }
  const auto number = leading_number(text);
  text = number ? number->rest : text;
  return number ? std::optional(number->value) : std::nullopt;
}

std::string range_text(char left, double low, double high, char right, double refused) {
  for (int digits = 6;; ++digits) {
    std::string text = formatted("%c%.*g, %.*g%c", left, digits, low, digits, high, right);
    if (digits == 17 || !contains(text, refused))
      return text;
  }
}

} // namespace

bool contains(std::string_view range, double value) {
  const bool low_open = range.starts_with('(');
  if (!low_open && !range.starts_with('['))
    return false;
  range.remove_prefix(1);
  const auto low = take_end(range);
  if (!low || !range.starts_with(", "))
    return false;
  range.remove_prefix(2);
  const auto high = take_end(range);
  const std::size_t end = range.find_first_of(")]"); // behind a unit
  if (!high || end == std::string_view::npos)
    return false;
  return (low_open ? value > *low : value >= *low) && (range[end] == ')' ? value < *high : value <= *high);
}

std::string refused_text(double value, std::string_view range, int digits) {
  const std::string rounded = formatted("%.*g", digits, value);
  const auto shown = parse_number(rounded);
  return shown && contains(range, *shown) ? exact_text(value) : rounded;
}

std::string closed_range(double low, double high, double refused) {
  return range_text('[', low, high, ']', refused);
}
std::string open_range(double low, double high, double refused) {
  return range_text('(', low, high, ')', refused);
}

void refuse(std::string_view name, double value, std::string_view unit, const char* range) {
  throw InvalidArgument(std::string(name), value, std::string(unit), range);
}

void refuse_open(std::string_view name, double value, std::string_view unit, double low, double high) {
  refuse(name, value, unit, open_range(low, high, value).c_str());
}

void refuse_closed(std::string_view name, double value, std::string_view unit, double low, double high) {
  refuse(name, value, unit, closed_range(low, high, value).c_str());
}

} // namespace granum::detail
