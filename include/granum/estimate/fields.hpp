// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include <granum/core/units.hpp>

/// The numbers of an answer, one row each; screen, JSON, CSV, Python and the page are written from this
/// table.
namespace granum::estimate {

/// A number of an answer. Vertical quantities also represent isotropic packings.
enum class Field : std::size_t {
  shear_modulus,
  shear_wave_speed,
  compression_wave_speed,
  bulk_modulus,
  young_modulus,
  poisson_ratio,
  horizontal_shear_modulus,
  horizontal_shear_wave_speed,
  horizontal_compression_wave_speed,
  horizontal_young_modulus,
  bulk_density,
  mechanical_coordination_number,
  rattler_fraction,
  coordination_number,
  contact_softness,
  vertical_exponent,
  horizontal_exponent,
  stress_exponent,
  strained_shear_modulus,
  modulus_ratio,
  damping_ratio,
  slip_strain
};
inline constexpr std::size_t field_count = 22;

/// For which packings a number is shown.
enum class Shown {
  always,
  by_direction, ///< if vertical and horizontal values differ
  in_full       ///< if all numbers are requested
};

/// How the contributions to a number's range are added.
enum class Spreading {
  logarithmic, ///< positive numbers, on a logarithmic scale
  difference   ///< numbers that may be 0 or negative
};

struct FieldRow {
  Field field;
  const char* key;              ///< in JSON and in Python
  const char* symbol;           ///< for an isotropic packing, on a screen
  const char* directed_symbol;  ///< where vertical and horizontal differ
  const char* column;           ///< in the heading of a CSV file
  Dimension dimension;          ///< of the number in SI
  const char* meaning;          ///< for an isotropic packing
  const char* directed_meaning; ///< where vertical and horizontal differ
  const char* in_water;         ///< appended to the meaning if there is water in the pores
  Shown shown;
  bool needs_density;  ///< only with the density of the grains
  Spreading spreading; ///< of its range
  double least;        ///< lower limit of any packing, and of the range
  double most;         ///< upper limit of isotropic packings, and of the range
};

/// All rows, in the order in which they are shown.
[[nodiscard]] std::span<const FieldRow, field_count> fields();
/// The row of one.
[[nodiscard]] const FieldRow& row_of(Field field);
/// The row with that key.
/// \throws   InvalidArgument with all keys for another text
/// Checked by tests/estimate/test_fields.cpp
[[nodiscard]] const FieldRow& field_of(std::string_view key);

} // namespace granum::estimate
