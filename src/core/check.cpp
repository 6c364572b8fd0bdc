// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/core/check.hpp>

#include <cmath>
#include <cstdio>
#include <string>

#include <granum/core/error.hpp>

namespace granum {

namespace {

[[noreturn]] void refuse(std::string_view name, double value, std::string_view unit,
                         const std::string& range) {
  throw InvalidArgument(std::string(name), value, std::string(unit), range);
}

double require(bool ok, std::string_view name, double value, std::string_view unit, const char* range) {
  if (!ok)
    refuse(name, value, unit, range);
  return value;
}

/// The range is put into words only when it is needed: checks stand on paths of some ten nanoseconds.
double require_between(bool ok, std::string_view name, double value, std::string_view unit,
                       const char* format, double low, double high) {
  if (!ok) {
    char range[80];
    std::snprintf(range, sizeof range, format, low, high);
    refuse(name, value, unit, range);
  }
  return value;
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
  return require_between(value >= low && value <= high, name, value, unit, "[%g, %g]", low, high);
}

double require_open(std::string_view name, double value, double low, double high, std::string_view unit) {
  return require_between(value > low && value < high, name, value, unit, "(%g, %g)", low, high);
}

double require_poisson_ratio(std::string_view name, double value) {
  return require(value > -1 && value <= 0.5, name, value, "", "(-1, 0.5]");
}

} // namespace granum
