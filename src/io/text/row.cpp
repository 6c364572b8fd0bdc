// SPDX-License-Identifier: GPL-3.0-or-later
#include "row.hpp"

#include <charconv>
#include <cmath>

#include <granum/core/text.hpp>

namespace granum::io {

namespace {

bool blank(char c) { return c == ' ' || c == '\t'; }
bool digit(char c) { return c >= '0' && c <= '9'; }

} // namespace

std::string shown(std::string_view text) {
  constexpr std::size_t longest = 40;
  std::string piece(text.substr(0, longest));
  for (char& c : piece)
    if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7e)
      c = '?';
  return "'" + piece + (text.size() > longest ? "...'" : "'");
}

int significant_digits(std::string_view number) {
  int digits = 0;
  for (const char c : number) {
    if (c == 'e' || c == 'E')
      break;
    if (digit(c) && (digits > 0 || c != '0'))
      ++digits;
  }
  return digits;
}

void TextRow::split() {
  fields_.clear();
  const std::string_view line = source_->line();
  const char* at = line.data();
  const char* const end = at + line.size();
  while (at != end) {
    while (at != end && blank(*at))
      ++at;
    const char* const begin = at;
    while (at != end && !blank(*at))
      ++at;
    if (at != begin)
      fields_.emplace_back(begin, static_cast<std::size_t>(at - begin));
  }
}

void TextRow::require_size(std::size_t count, std::string_view what) const {
  if (fields_.size() != count)
    source_->fail("expected " + std::to_string(count) + " " + std::string(what) + ", found " +
                  std::to_string(fields_.size()));
}

std::string_view TextRow::field(std::size_t k, std::string_view what) const {
  if (k >= fields_.size())
    source_->fail("expected " + std::string(what) + " as field " + std::to_string(k + 1) + ", found " +
                  std::to_string(fields_.size()) + " fields");
  return fields_[k];
}

double TextRow::number(std::size_t k, std::string_view what) const {
  const std::string_view text = field(k, what);
  const auto number = leading_number(text);
  if (!number || !number->rest.empty())
    source_->fail("expected a finite number as " + std::string(what) + ", found " + shown(text));
  return number->value;
}

Vec3 TextRow::vector(std::size_t k, std::string_view what) const {
  return {number(k, what), number(k + 1, what), number(k + 2, what)};
}

long TextRow::integer(std::size_t k, std::string_view what) const {
  const std::string_view text = field(k, what);
  long value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc{} && end == text.data() + text.size())
    return value;
  const double written = number(k, what);
  if (written != std::floor(written) || std::abs(written) > 9e15)
    source_->fail("expected an integer as " + std::string(what) + ", found " + shown(text));
  const auto whole = static_cast<long>(written);
  if (significant_digits(text) < static_cast<int>(std::to_string(std::abs(whole)).size()))
    source_->fail(std::string(what) + " " + shown(text) +
                  " has lost digits: write the file again with more (format float %.17g)");
  return whole;
}

std::size_t TextRow::count(std::size_t k, std::string_view what) const {
  const long value = integer(k, what);
  if (value < 0)
    source_->fail("expected a number of " + std::string(what) + ", found " + std::to_string(value));
  return static_cast<std::size_t>(value);
}

} // namespace granum::io
