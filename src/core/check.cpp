// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/core/check.hpp>

#include <cstdio>
#include <string>

#include <granum/core/error.hpp>

namespace granum::detail {

namespace {

std::string range_text(const char* format, double low, double high) {
  char range[80];
  std::snprintf(range, sizeof range, format, low, high);
  return range;
}

} // namespace

std::string closed_range(double low, double high) { return range_text("[%g, %g]", low, high); }
std::string open_range(double low, double high) { return range_text("(%g, %g)", low, high); }

void refuse(std::string_view name, double value, std::string_view unit, const char* range) {
  throw InvalidArgument(std::string(name), value, std::string(unit), range);
}

void refuse_open(std::string_view name, double value, std::string_view unit, double low, double high) {
  refuse(name, value, unit, open_range(low, high).c_str());
}

void refuse_closed(std::string_view name, double value, std::string_view unit, double low, double high) {
  refuse(name, value, unit, closed_range(low, high).c_str());
}

} // namespace granum::detail
