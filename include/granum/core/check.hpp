// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <string>
#include <string_view>

/// Range checks of public functions. Each returns its value, so that a check can be written where the value
/// is used.
/// Assumes   name and unit as the user knows them; unit "" for a pure number.
/// \throws   InvalidArgument with name, value, unit and the allowed range; NaN and infinity never pass.
/// Checked by tests/core/test_check.cpp
namespace granum {

/// Common part of the checks: cold, so that a passed check costs one comparison.
namespace detail {
[[noreturn]] void refuse(std::string_view name, double value, std::string_view unit, const char* range);
[[noreturn]] void refuse_open(std::string_view name, double value, std::string_view unit, double low,
                              double high);
[[noreturn]] void refuse_closed(std::string_view name, double value, std::string_view unit, double low,
                                double high);
/// "[low, high]", "(low, high)" as the checks write them: with as many digits as exclude the refused value.
[[nodiscard]] std::string closed_range(double low, double high, double refused);
[[nodiscard]] std::string open_range(double low, double high, double refused);
/// Whether a range that begins as "[0, 1)" contains a value; false if an end is in words.
[[nodiscard]] bool contains(std::string_view range, double value);
/// A value that a range refuses, with `digits` digits, or all where rounding would move it into the range.
[[nodiscard]] std::string refused_text(double value, std::string_view range, int digits);
inline constexpr double largest = std::numeric_limits<double>::max();
} // namespace detail

/// Any finite number.
inline double require_finite(std::string_view name, double value, std::string_view unit = "") {
  if (!(value >= -detail::largest && value <= detail::largest)) [[unlikely]]
    detail::refuse(name, value, unit, "(-inf, inf)");
  return value;
}
/// value > 0 and finite.
inline double require_positive(std::string_view name, double value, std::string_view unit = "") {
  if (!(value > 0 && value <= detail::largest)) [[unlikely]]
    detail::refuse(name, value, unit, "(0, inf)");
  return value;
}
/// value >= 0 and finite.
inline double require_non_negative(std::string_view name, double value, std::string_view unit = "") {
  if (!(value >= 0 && value <= detail::largest)) [[unlikely]]
    detail::refuse(name, value, unit, "[0, inf)");
  return value;
}
/// low <= value <= high.
inline double require_closed(std::string_view name, double value, double low, double high,
                             std::string_view unit = "") {
  if (!(value >= low && value <= high)) [[unlikely]]
    detail::refuse_closed(name, value, unit, low, high);
  return value;
}
/// low < value < high.
inline double require_open(std::string_view name, double value, double low, double high,
                           std::string_view unit = "") {
  if (!(value > low && value < high)) [[unlikely]]
    detail::refuse_open(name, value, unit, low, high);
  return value;
}

/// Poisson's ratio of an isotropic elastic solid: -1 < value <= 0.5.
inline double require_poisson_ratio(std::string_view name, double value) {
  if (!(value > -1 && value <= 0.5)) [[unlikely]]
    detail::refuse(name, value, "", "(-1, 0.5]");
  return value;
}

} // namespace granum
