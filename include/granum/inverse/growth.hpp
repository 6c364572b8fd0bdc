// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

/// What is taken for the packing at states other than those of its measurements, with the names that programs
/// give it. Checked by tests/inverse/test_growth.cpp
namespace granum::inverse {

/// How z* follows the mean stress p from state to state of one packing.
enum class GrowthRule {
  packings, ///< as effective::carried_contacts, which own packings taught
  fixed,    ///< the same at every stress
  fitted    ///< (z* - isostatic point) ~ p^g, g fitted; asks for two stresses
};
inline constexpr std::array all_growth_rules{GrowthRule::packings, GrowthRule::fixed, GrowthRule::fitted};

/// Whose state it is that is asked about.
enum class AskedPacking {
  same, ///< the one that was measured
  /// Another of the same grains at the void ratio of the state asked about: as far between the loosest and
  /// the densest that effective::contact_prior knows there.
  prepared_alike
};
inline constexpr std::array all_asked_packings{AskedPacking::same, AskedPacking::prepared_alike};

/// The name of the enumerator.
/// \throws   InvalidArgument for a value that is none of the enumerators
[[nodiscard]] std::string_view name(GrowthRule growth);
[[nodiscard]] std::string_view name(AskedPacking specimen);

/// What `text` names exactly.
/// \throws   InvalidArgument with all names for another text
[[nodiscard]] GrowthRule growth_rule_of(std::string_view text);
[[nodiscard]] AskedPacking asked_packing_of(std::string_view text);

} // namespace granum::inverse
