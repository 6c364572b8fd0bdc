// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/stress/ground.hpp>

#include <algorithm>

#include <granum/core/error.hpp>

namespace granum::stress {

namespace {

void require_valid(const Ground& g) {
  require_non_negative("unit_weight", g.unit_weight, "N/m3");
  require_positive("water_unit_weight", g.water_unit_weight, "N/m3");
  require_closed("earth_pressure_at_rest", g.earth_pressure_at_rest, least_stress_ratio,
                 largest_stress_ratio);
  require_non_negative("surcharge", g.surcharge, "Pa");
  if (!g.water_table)
    return;
  require_finite("water_table", *g.water_table, "m");
  require_finite("saturated_unit_weight", g.saturated_unit_weight, "N/m3");
  require_non_negative("saturated_unit_weight - water_unit_weight",
                       g.saturated_unit_weight - g.water_unit_weight, "N/m3");
}

} // namespace

GroundStress stress_at(const Ground& ground, double depth) {
  require_valid(ground);
  require_non_negative("depth", depth, "m");
  const double table = ground.water_table.value_or(depth);
  const double wet = std::clamp(depth - table, 0.0, depth); // part of the depth below the water table
  const double standing_water = std::max(0.0, -table);
  const double buoyant = ground.saturated_unit_weight - ground.water_unit_weight;
  const double u = ground.water_unit_weight * (wet + standing_water);
  const double v = ground.surcharge + ground.unit_weight * (depth - wet) + buoyant * wet;
  const double h = ground.earth_pressure_at_rest * v;
  return {.total = {.v = v + u, .h = h + u}, .pore_pressure = u, .effective = {.v = v, .h = h}};
}

} // namespace granum::stress
