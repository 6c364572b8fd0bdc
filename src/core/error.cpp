// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/core/error.hpp>

#include <granum/core/number.hpp>

namespace granum {

namespace {

std::string out_of_range_text(const std::string& name, double value, const std::string& unit,
                              const std::string& range) {
  return name + " = " + detail::formatted("%.10g", value) + (unit.empty() ? "" : " " + unit) +
         " is outside " + range;
}

} // namespace

InvalidArgument::InvalidArgument(const std::string& name, double value, const std::string& unit,
                                 const std::string& range)
    : Error(out_of_range_text(name, value, unit, range)), refused_({name, value, unit, range}) {}

FileError::FileError(const std::string& path, std::size_t line, const std::string& what)
    : Error(path + (line > 0 ? ":" + std::to_string(line) : "") + ": " + what), path_(path), line_(line) {}

} // namespace granum
