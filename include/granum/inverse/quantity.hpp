// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

#include <granum/core/statistics.hpp>
#include <granum/effective/exponents.hpp>

namespace granum::inverse {

/// Measured quantities at small strain: a modulus [Pa], or a wave speed [m/s].
enum class Quantity {
  G_vh,   ///< shear modulus of a vertical plane; G of an isotropic packing
  G_hh,   ///< shear modulus of the horizontal plane
  K,      ///< bulk modulus
  V_s,    ///< shear wave with vertical propagation or polarisation
  V_s_hh, ///< shear wave with horizontal propagation and polarisation
  V_p,    ///< compression wave that travels vertically
  V_p_h   ///< compression wave that travels horizontally
};

/// A quantity and its modulus X: the quantity is X itself, or sqrt(X/density).
struct QuantityRow {
  Quantity quantity;
  const char* key; ///< in tables and JSON
  effective::Modulus modulus;
  bool speed;
  const char* meaning;
};

/// All of them.
[[nodiscard]] std::span<const QuantityRow> quantities();
/// The row of one.
[[nodiscard]] const QuantityRow& row_of(Quantity quantity);
/// The quantity of a key.
/// \throws   InvalidArgument with all keys for another text
[[nodiscard]] Quantity quantity_of(std::string_view key);

/// \throws   InvalidArgument unless the value is between 0.01 and 1e5 m/s or 1 and 1e14 Pa, as of any solid,
///           and its standard error from 0 to the value: with a larger one every positive number is possible.
/// Checked by tests/inverse/test_inference.cpp
void require_measured(const QuantityRow& row, const Measured& value);

} // namespace granum::inverse
