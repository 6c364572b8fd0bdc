// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/stress/stress.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <granum/core/error.hpp>

namespace granum::stress {

double mobilised_friction_angle(const AxialStress& stress) {
  require_non_negative("vertical stress", stress.v, "Pa");
  require_non_negative("horizontal stress", stress.h, "Pa");
  require_positive("sum of the stresses", stress.v + stress.h, "Pa");
  return std::asin(std::abs(stress.v - stress.h) / (stress.v + stress.h));
}

namespace {

void require_eta_on(ShearPath path, double eta) {
  const bool inside = is_compression(path) ? eta >= 0 && eta < 3 : eta > -1.5 && eta <= 0;
  if (!inside)
    throw InvalidArgument("eta", eta, "",
                          (is_compression(path) ? "[0, 3) of " : "(-1.5, 0] of ") + std::string(name(path)));
}

} // namespace

std::string_view name(ShearPath path) {
  switch (path) {
  case ShearPath::txc:
    return "TXC";
  case ShearPath::rtxc:
    return "RTXC";
  case ShearPath::rtxe:
    return "RTXE";
  case ShearPath::txe:
    return "TXE";
  }
  throw InvalidArgument("stress path is not one of the known ones");
}

bool is_compression(ShearPath path) { return path == ShearPath::txc || path == ShearPath::rtxc; }

AxialStress stress_on_path(ShearPath path, double start, double eta) {
  require_positive("stress at the start of the path", start, "Pa");
  require_eta_on(path, eta);
  const double v_by_p = 1 + 2 * eta / 3;
  const double h_by_p = 1 - eta / 3;
  const bool horizontal_constant = path == ShearPath::txc || path == ShearPath::rtxe;
  return horizontal_constant ? AxialStress{.v = start * (v_by_p / h_by_p), .h = start}
                             : AxialStress{.v = start, .h = start * (h_by_p / v_by_p)};
}

double failure_ratio(ShearPath path, double friction_angle) {
  require_open("friction_angle", friction_angle, 0, std::numbers::pi / 2, "rad");
  const double sine = std::sin(friction_angle);
  return is_compression(path) ? 6 * sine / (3 - sine) : -6 * sine / (3 + sine);
}

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
