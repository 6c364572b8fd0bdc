// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <string_view>

#include <granum/core/numerics.hpp>
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

/// \file
/// Assumptions on the packing at states other than the measured ones, and their names in programs.
/// Checked by tests/inverse/test_growth.cpp

/// How z* depends on the mean stress p between states of one packing.
enum class GrowthRule {
  packings, ///< as effective::carried_contacts, calibrated on granum's packings
  fixed,    ///< the same at every stress
  fitted    ///< (z* - isostatic point) ~ p^g, g fitted; needs two stresses
};
inline constexpr std::array all_growth_rules{GrowthRule::packings, GrowthRule::fixed, GrowthRule::fitted};

/// The packing of a predicted state.
enum class AskedPacking {
  same, ///< the measured one
  /// Another packing of the same grains at the void ratio of the predicted state: its z* has the same
  /// relative position between the loosest and the densest of effective::contact_prior.
  prepared_alike
};
inline constexpr std::array all_asked_packings{AskedPacking::same, AskedPacking::prepared_alike};

/// The name of the enumerator.
/// \throws   InvalidArgument for a value that is none of the enumerators
[[nodiscard]] std::string_view name(GrowthRule growth);
[[nodiscard]] std::string_view name(AskedPacking specimen);

/// The enumerator with exactly the name `text`.
/// \throws   InvalidArgument with all names for another text
[[nodiscard]] GrowthRule growth_rule_of(std::string_view text);
[[nodiscard]] AskedPacking asked_packing_of(std::string_view text);

} // namespace granum::inverse
