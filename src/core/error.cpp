// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/core/error.hpp>

#include <granum/core/check.hpp>

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
