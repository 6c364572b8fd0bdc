// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

/// Assumptions on the packing at states other than the measured ones, and their names in programs.
/// Checked by tests/inverse/test_growth.cpp
namespace granum::inverse {

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
