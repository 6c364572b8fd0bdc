// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "cli/document/document.hpp"
#include "depth.hpp"

/// What a profile of V_s is for the response of a site. Checked by tests/cli/test_site.cpp
namespace granum::cli {

/// Depth to which building codes average V_s [m].
inline constexpr double code_depth = 30;

/// A shear wave from the base of a profile up to the surface. Ranges are those of V_s, low or high at all
/// depths alike: the sand differs from others as a whole.
struct SiteResponse {
  double base = 0;                  ///< deepest depth that was asked [m]
  double averaged_to = 0;           ///< 30 m, or the base of a profile that does not reach so deep [m]
  estimate::Range speed = {};       ///< time average of V_s from the surface to there [m/s]
  estimate::Range travel_time = {}; ///< from the base to the surface [s]
  estimate::Range period = {};      ///< 4 H/V_s of the ground above the base: four travel times [s]
};

/// From V_s at small strain, from the surface to the base, also where fewer depths were asked.
/// \throws   InvalidArgument where a depth has no answer, or its V_s may be 0
/// Accuracy  travel time 1e-3: eight depths between every two of the surface, the tops of layers, the water
///           table, 30 m and the base
[[nodiscard]] SiteResponse site_response(const std::vector<Layer>& layers, double base);

/// The numbers as lines of a screen and members of "site" in JSON.
[[nodiscard]] Items site_items(const SiteResponse& site);
/// The same as a line of text.
[[nodiscard]] std::string site_text(const SiteResponse& site);

} // namespace granum::cli
