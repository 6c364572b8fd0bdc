// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/core/check.hpp>

#include <string>

#include <granum/core/error.hpp>
#include <granum/core/number.hpp>

namespace granum::detail {

std::string closed_range(double low, double high) { return formatted("[%g, %g]", low, high); }
std::string open_range(double low, double high) { return formatted("(%g, %g)", low, high); }

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
