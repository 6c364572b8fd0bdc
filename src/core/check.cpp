// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/core/check.hpp>

#include <cstdio>
#include <string>

#include <granum/core/error.hpp>

namespace granum::detail {

namespace {

/// The range is put into words only when it is needed: checks stand on paths of some ten nanoseconds.
[[noreturn]] void refuse_between(std::string_view name, double value, std::string_view unit,
                                 const char* format, double low, double high) {
  char range[80];
  std::snprintf(range, sizeof range, format, low, high);
  refuse(name, value, unit, range);
}

} // namespace

void refuse(std::string_view name, double value, std::string_view unit, const char* range) {
  throw InvalidArgument(std::string(name), value, std::string(unit), range);
}

void refuse_open(std::string_view name, double value, std::string_view unit, double low, double high) {
  refuse_between(name, value, unit, "(%g, %g)", low, high);
}

void refuse_closed(std::string_view name, double value, std::string_view unit, double low, double high) {
  refuse_between(name, value, unit, "[%g, %g]", low, high);
}

} // namespace granum::detail
