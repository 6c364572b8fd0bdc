// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <granum/stress/axial_stress.hpp>

/// Stresses in level ground: total, pore pressure, and effective.
/// Checked by tests/stress/test_ground.cpp
namespace granum::stress {

/// Level ground with two unit weights, above and below the water table, and a load on it.
struct Ground {
  double unit_weight = 0;           ///< above the water table, with its water, >= 0 [N/m3]
  double saturated_unit_weight = 0; ///< below it, of grains and water together, >= water_unit_weight [N/m3]
  /// Depth of the water table [m]; none: the ground is dry. Negative: height of water above the ground.
  std::optional<double> water_table = std::nullopt;
  double water_unit_weight = 0; ///< > 0 [N/m3]
  /// K_0, horizontal over vertical effective stress, from least_stress_ratio to largest_stress_ratio [1].
  double earth_pressure_at_rest = 1;
  double surcharge = 0; ///< on the surface, >= 0 [Pa]
};

/// Compression positive [Pa].
struct GroundStress {
  AxialStress total;        ///< of grains and water together
  double pore_pressure = 0; ///< u
  AxialStress effective;    ///< carried by the grains: total - u in both directions
};

/// Stresses at a depth: sigma_v is the weight above and the surcharge, u is hydrostatic below the water table
/// and 0 above it, sigma'_v = sigma_v - u, sigma'_h = K_0 sigma'_v, sigma_h = sigma'_h + u.
/// Assumes   level ground at rest, one K_0 at all depths, water at rest, no suction above its table.
/// \param    depth   below the surface, >= 0 [m]
/// \throws   InvalidArgument naming the member or the depth that is out of its range
/// Accuracy  8 ulp of the largest term.  Checked by tests/stress/test_ground.cpp
[[nodiscard]] GroundStress stress_at(const Ground& ground, double depth);

} // namespace granum::stress
