// SPDX-License-Identifier: GPL-3.0-or-later
#include "harness.hpp"

#include <algorithm>
#include <limits>

#include <granum/core/text.hpp>

namespace accuracy {

namespace {

/// Spacing of doubles at that magnitude, that of the smallest normal number below it.
Real spacing(const Real& magnitude) {
  using std::abs;
  const double nearest =
      std::max(std::abs(static_cast<double>(magnitude)), std::numeric_limits<double>::min());
  return Real(std::ldexp(1.0, std::ilogb(nearest) - 52));
}

double error_in(double value, const Real& reference, const Real& unit) {
  if (!std::isfinite(value))
    return std::numeric_limits<double>::infinity();
  const Real error = abs(Real(value) - reference) / unit;
  return static_cast<double>(error);
}

} // namespace

double ulps(double value, const Real& reference) {
  if (reference == 0)
    return value == 0 ? 0 : std::numeric_limits<double>::infinity();
  return error_in(value, reference, spacing(reference));
}

Table::Row& Table::row(const std::string& function, const std::string& domain, Reach reach) {
  const auto known = std::find_if(rows_.begin(), rows_.end(),
                                  [&](const Row& r) { return r.function == function && r.domain == domain; });
  if (known != rows_.end())
    return *known;
  rows_.push_back({.function = function, .domain = domain, .reach = reach.ulp, .where = {}});
  return rows_.back();
}

void Table::take_error(Row& row, double error, const std::string& where) {
  ++row.samples;
  if (error > row.worst || row.where.empty()) {
    row.worst = std::max(row.worst, error);
    row.where = where;
  }
}

void Table::take(const std::string& function, const std::string& domain, Reach reach, double value,
                 const Real& reference, const std::string& where) {
  take_error(row(function, domain, reach), ulps(value, reference), where);
}

void Table::take_against(const std::string& function, const std::string& domain, Reach reach, double value,
                         const Real& reference, const Real& scale, const std::string& where) {
  take_error(row(function, domain, reach), error_in(value, reference, spacing(scale)), where);
}

std::string said(std::initializer_list<std::pair<const char*, double>> arguments) {
  std::string text;
  for (const auto& [name, value] : arguments)
    text += (text.empty() ? "" : " ") + std::string(name) + "=" + granum::short_text(value, 6);
  return text;
}

} // namespace accuracy
