// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <granum/core/units.hpp>
#include <granum/elastic/waves.hpp>
#include <granum/estimate/input_values.hpp>
#include <granum/estimate/notes.hpp>
#include <granum/stress/stress.hpp>

#include "input_options.hpp"

/// Level ground that gives depths their stress and their water.
namespace granum::cli {

inline constexpr const char* ground_group = "Ground";

/// Level ground, of depths or of the rows of a table.
struct GroundOptions {
  std::string depth;  ///< "0m..30m"; empty for another sweep
  std::string layers; ///< file; empty for a single layer
  Number unit_weight{0, Dimension::unit_weight, "gamma"};
  Number saturated_unit_weight{0, Dimension::unit_weight, "gamma_sat"};
  Number water_table{0, Dimension::length};
  Number water_unit_weight{elastic::water_density * standard_gravity, Dimension::unit_weight};
  Number earth_pressure_at_rest{0.5, Dimension::dimensionless, "K_0 K0", "--k0"};
  Number surcharge{0, Dimension::pressure};
  Number row_depth{0, Dimension::length, "z", "--depth"}; ///< of a table's row
  Number top{0, Dimension::length, "top_depth", "--top"}; ///< of a layer
};

/// The ground given by the options.
struct GroundCase {
  stress::Ground ground;
  double saturation = 0; ///< of the pores above the water table
  estimate::Notes assumptions;
  Validity validity; ///< where weights and void ratio contradict each other
};

/// Adds the weights, the water and the surcharge of the ground.
/// \param    in_ground   what these options need
void add_ground(Command& command, GroundOptions& options, const std::vector<Need>& in_ground);

/// \param    inputs   of the soil
/// \throws   InvalidArgument for options that contradict each other or are out of range
[[nodiscard]] GroundCase resolve_ground(const InputValues& inputs, const GroundOptions& options);

/// The inputs with the effective stress and the saturation of a depth.
/// \param    depth   from the top of the ground [m]
[[nodiscard]] InputValues values_in_ground(const InputValues& inputs, const GroundCase& ground, double depth);

} // namespace granum::cli
