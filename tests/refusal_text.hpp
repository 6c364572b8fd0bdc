// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>

/// Whether a message "x = 1 is outside [1, 2]" prints a number that is within the range it prints.
inline bool contradicts_itself(std::string_view text) {
  constexpr std::string_view is_outside = " is outside ";
  const std::size_t middle = text.find(is_outside);
  if (middle == std::string_view::npos)
    return false;
  const std::size_t equals = text.rfind(" = ", middle);
  const auto number =
      granum::leading_number(text.substr(equals == std::string_view::npos ? 0 : equals + 3, middle));
  return number && granum::detail::contains(text.substr(middle + is_outside.size()), number->value);
}

/// A number, and others within rounding, a tolerance or a step of it, to either side.
inline std::vector<double> around(double end) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> values{end, std::nextafter(end, infinity), std::nextafter(end, -infinity)};
  for (const double share : {1e-14, 1e-12, 1e-11, 3e-10, 1e-9, 1e-8, 4e-7, 1e-6, 7e-6, 1e-4, 1e-2})
    for (const double side : {1.0, -1.0})
      values.push_back(end == 0 ? side * share : end * (1 + side * share));
  return values;
}
