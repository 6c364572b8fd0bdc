// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/core/check.hpp>

#include <cmath>
#include <cstdio>
#include <string>

#include <granum/core/error.hpp>

namespace granum {

namespace {

double require(bool ok, std::string_view name, double value, std::string_view unit,
               const std::string& range) {
  if (!ok)
    throw InvalidArgument(std::string(name), value, std::string(unit), range);
  return value;
}

std::string interval(const char* format, double low, double high) {
  char text[80];
  std::snprintf(text, sizeof text, format, low, high);
  return text;
}

} // namespace

double require_finite(std::string_view name, double value, std::string_view unit) {
  return require(std::isfinite(value), name, value, unit, "(-inf, inf)");
}

double require_positive(std::string_view name, double value, std::string_view unit) {
  return require(std::isfinite(value) && value > 0, name, value, unit, "(0, inf)");
}

double require_non_negative(std::string_view name, double value, std::string_view unit) {
  return require(std::isfinite(value) && value >= 0, name, value, unit, "[0, inf)");
}

double require_closed(std::string_view name, double value, double low, double high, std::string_view unit) {
  return require(value >= low && value <= high, name, value, unit, interval("[%g, %g]", low, high));
}

double require_open(std::string_view name, double value, double low, double high, std::string_view unit) {
  return require(value > low && value < high, name, value, unit, interval("(%g, %g)", low, high));
}

double require_poisson_ratio(std::string_view name, double value) {
  return require(value > -1 && value <= 0.5, name, value, "", "(-1, 0.5]");
}

} // namespace granum
