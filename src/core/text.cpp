// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/core/text.hpp>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <iterator>
#include <string>
#include <system_error>
#include <utility>

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

constexpr const char* hex_digits = "0123456789abcdef";

} // namespace

std::string printable(std::string_view text) {
  return with_hidden(text, [](std::string_view character) {
    std::string bytes;
    for (const char c : character) {
      const auto value = static_cast<unsigned char>(c);
      bytes += {'\\', 'x', hex_digits[value / 16], hex_digits[value % 16]};
    }
    return bytes;
  });
}

std::string printable_json(std::string_view json) {
  return with_hidden(json, [](std::string_view character) {
    const char32_t code = code_point(character);
    const auto unit = [](char32_t of) {
      return std::string{'\\',
                         'u',
                         hex_digits[of >> 12],
                         hex_digits[of >> 8 & 15],
                         hex_digits[of >> 4 & 15],
                         hex_digits[of & 15]};
    };
    return code < 0x10000 ? unit(code)
                          : unit(0xD7C0 + (code >> 10)) + unit(0xDC00 + (code & 0x3FF)); // a pair of UTF-16
  });
}

namespace {

std::string plain(std::string_view word) {
  std::string text(word);
  for (char& c : text)
    c = c == '_' || c == ' ' ? '-' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

template <class Fits>
std::vector<std::string> those(std::span<const std::string> known, const Fits& fits) {
  std::vector<std::string> found;
  for (const std::string& word : known)
    if (fits(plain(word)))
      found.push_back(word);
  return found;
}

} // namespace

std::size_t slips_between(std::string_view a, std::string_view b) {
  // rows of the table of distances between the beginnings of a and of b: two back, one back, this one
  std::vector<std::size_t> before_last(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j)
    last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool same = a[i - 1] == b[j - 1];
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
    before_last = last;
    last = row;
  }
  return last[b.size()];
}

bool same_word(std::string_view a, std::string_view b) { return plain(a) == plain(b); }

std::vector<std::string> near_misses(std::string_view word, std::span<const std::string> known) {
  const std::string typed = plain(word);
  std::vector<std::string> found = those(known, [&](const std::string& name) { return name == typed; });
  if (found.empty() && typed.size() >= 3)
    found = those(known, [&](const std::string& name) { return name.starts_with(typed); });
  const auto begins_word = [&](const std::string& name) {
    return name.size() >= 3 && typed.starts_with(name);
  };
  if (found.empty())
    found = those(known, begins_word);
  const auto ends = [&](const std::string& name) {
    return name.ends_with("." + typed) || name.ends_with("-" + typed);
  };
  if (found.empty() && typed.size() >= 3)
    found = those(known, ends);
  for (std::size_t slips = 1; found.empty() && slips <= (typed.size() + 2) / 4; ++slips)
    found = those(known, [&](const std::string& name) { return slips_between(typed, name) == slips; });
  return found;
}

std::string did_you_mean(std::string_view word, std::span<const std::string> known) {
  const std::vector<std::string> near = near_misses(word, known);
  if (near.empty() || near.size() > 3)
    return {};
  std::string text = "; did you mean " + near[0];
  for (std::size_t k = 1; k < near.size(); ++k)
    text += (k + 1 < near.size() ? ", " : " or ") + near[k];
  return text + "?";
}

std::string unknown_word(std::string_view kind, std::string_view word, std::span<const std::string> known) {
  std::string text = std::string(kind) + " '" + std::string(word) + "' is unknown";
  const std::string question = did_you_mean(word, known);
  if (!question.empty())
    return text + question;
  for (const std::string& name : known)
    text += (&name == known.data() ? "; known are " : ", ") + name;
  return text;
}

} // namespace granum
