// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

#include <granum/effective/exponents.hpp>

namespace granum::inverse {

/// What is measured of a packing at small strain: a modulus [Pa], or the speed of a wave [m/s].
enum class Quantity {
  G_vh,   ///< shear modulus of a vertical plane, that of an isotropic packing
  G_hh,   ///< shear modulus of the horizontal plane
  K,      ///< bulk modulus
  V_s,    ///< shear wave that travels or swings vertically
  V_s_hh, ///< shear wave that travels and swings horizontally
  V_p,    ///< compression wave that travels vertically
  V_p_h   ///< compression wave that travels horizontally
};

/// A quantity and the modulus X behind it: it is X itself, or sqrt(X/density).
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

} // namespace granum::inverse
