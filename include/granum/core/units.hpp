// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

/// Units at the border of the library: conversion of text with a unit to SI. The same in every locale.
/// Checked by tests/core/test_units.cpp
namespace granum {

enum class Dimension {
  dimensionless, ///< 1 or %
  pressure,      ///< stress, modulus [Pa]
  length,        ///< [m]
  angle,         ///< [rad]
  density,       ///< [kg/m^3]
  unit_weight,   ///< weight per volume [N/m^3]
  time,          ///< [s]
  force,         ///< [N]
  speed,         ///< [m/s]
};

/// Weight per mass, for densities given as unit weights and vice versa [m/s^2].
inline constexpr double standard_gravity = 9.80665;

/// A unit that programs and files may use: value in SI = factor * value in this unit.
struct Unit {
  std::string_view symbol;
  Dimension dimension = Dimension::dimensionless;
  double factor = 1;
};

/// The unit with the symbol `symbol`; empty if unknown. Capital letters do not matter (kpa is kPa) where
/// one unit alone is written so, and where more than the prefix m or M differs: mPa is no MPa, mn none of mN,
/// MN.
[[nodiscard]] std::optional<Unit> find_unit(std::string_view symbol);
/// The SI unit that values of a dimension are returned in; "" for a pure number.
[[nodiscard]] std::string_view si_symbol(Dimension dimension);
/// "a pressure", "a length", ...: the dimension in the words of error messages.
[[nodiscard]] std::string_view description(Dimension dimension);

/// The SI value of a number with its unit: "100kPa", "0.5 mm", "26.5deg", "2650kg/m3"; a pure number has none
/// or %. Unit weights are accepted as densities and vice versa, by standard gravity.
/// \param    name  of the argument, as the user knows it; in every error
/// \throws   InvalidArgument for a number without unit where one is needed, an unknown unit, one of another
///           dimension, a decimal comma, text that is no number, NaN, infinity or overflow
[[nodiscard]] double parse_quantity(std::string_view name, std::string_view text, Dimension dimension);

/// Whether a column heading is `quantity` alone or `quantity` with a unit, as p, p_kPa, "p (kPa)", "p [kPa]"
/// and "p kPa" are for p; "e (-)" and "e [-]" are pure numbers. A word of five letters or more, such as
/// void_ratio, is read in any case and with blanks or hyphens: "Void Ratio"; in symbols case matters.
[[nodiscard]] bool is_column_of(std::string_view heading, std::string_view quantity);
/// The factor to SI that the heading of a column states: 1e3 for sigma_v_kPa.
/// Assumes   is_column_of(heading, quantity)
/// \throws   InvalidArgument if a dimensional quantity has no unit in its heading, or one of another
/// dimension
[[nodiscard]] double column_factor(std::string_view heading, std::string_view quantity, Dimension dimension);

/// A value with the fitting prefix and 4 significant digits, for tables: 3.66e7 Pa is "36.6 MPa"; angles in
/// degrees.
[[nodiscard]] std::string pretty(double value, Dimension dimension);

} // namespace granum
