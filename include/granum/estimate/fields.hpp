// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include <granum/core/units.hpp>

/// The numbers of an answer, a row each: screen, JSON, CSV, Python and the page are written from this table.
namespace granum::estimate {

/// A number of an answer. Vertical quantities are those of isotropic packings too.
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

/// Which packings a number is shown of.
enum class Shown {
  always,
  by_direction, ///< of those whose vertical and horizontal differ
  in_full       ///< where everything is asked for
};

/// How a number's range adds up, and where it ends.
enum class Spreading {
  logarithmic, ///< positive numbers, by their logarithm
  difference   ///< numbers that may be 0 or negative
};

struct FieldRow {
  Field field;
  const char* key;              ///< in JSON and in Python
  const char* symbol;           ///< of an isotropic packing, on a screen
  const char* directed_symbol;  ///< where vertical and horizontal differ
  const char* column;           ///< in the heading of a CSV file
  Dimension dimension;          ///< of the number in SI
  const char* meaning;          ///< of an isotropic packing
  const char* directed_meaning; ///< where vertical and horizontal differ
  const char* in_water;         ///< what is added to the meaning where there is water in the pores
  Shown shown;
  bool needs_density;  ///< only with the density of the grains
  Spreading spreading; ///< of its range
  double least;        ///< no packing has less; its range ends there
  double most;         ///< no isotropic packing has more; its range ends there
};

/// All of them, in the order in which they are shown.
[[nodiscard]] std::span<const FieldRow, field_count> fields();
/// The row of one.
[[nodiscard]] const FieldRow& row_of(Field field);
/// The row with that key.
/// \throws   InvalidArgument with all keys for another text
/// Checked by tests/estimate/test_fields.cpp
[[nodiscard]] const FieldRow& field_of(std::string_view key);

} // namespace granum::estimate
