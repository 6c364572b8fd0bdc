// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

/// Range checks of public functions. Each returns its value, so that a check can stand where the value is
/// used.
/// Assumes   name and unit are what the user knows the argument by; unit "" for a pure number.
/// \throws   InvalidArgument with name, value, unit and the allowed range; NaN and infinity never pass.
/// Checked by tests/core/test_check.cpp
namespace granum {

/// Any finite number.
double require_finite(std::string_view name, double value, std::string_view unit = "");
/// value > 0 and finite.
double require_positive(std::string_view name, double value, std::string_view unit = "");
/// value >= 0 and finite.
double require_non_negative(std::string_view name, double value, std::string_view unit = "");
/// low <= value <= high.
double require_closed(std::string_view name, double value, double low, double high,
                      std::string_view unit = "");
/// low < value < high.
double require_open(std::string_view name, double value, double low, double high, std::string_view unit = "");

/// Poisson's ratio of an isotropic elastic solid: -1 < value <= 0.5.
double require_poisson_ratio(std::string_view name, double value);

} // namespace granum
