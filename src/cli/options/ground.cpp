// SPDX-License-Identifier: GPL-3.0-or-later
#include "ground.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>
#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/elastic/waves.hpp>

namespace granum::cli {

namespace {

/// Relative difference between a given unit weight and that of void ratio and grain density that is not
/// reported.
constexpr double unit_weight_tolerance = 0.02;

/// The mass of the packing from its void ratio.
struct PackingMass {
  double grain_density, void_ratio;

  [[nodiscard]] double unit_weight(double saturation) const {
    return standard_gravity * elastic::bulk_density({.grain_density = grain_density,
                                                     .void_ratio = void_ratio,
                                                     .pore_density = saturation * elastic::water_density});
  }
  [[nodiscard]] double saturation(double unit_weight) const {
    return elastic::saturation_of_bulk_density(unit_weight / standard_gravity, grain_density, void_ratio);
  }
};

std::string weight(double value) { return pretty(value, Dimension::unit_weight); }

/// \param    expected   unit weight at the assumed saturation of the pores
void note_contradiction(const Number& given, double expected, const char* pores, const PackingMass& mass,
                        Validity& validity) {
  if (std::abs(given.value - expected) <= unit_weight_tolerance * expected)
    return;
  validity.add(fmt::format(
      "{} {} contradicts void ratio {} and grains of {}, whose unit weight is {} with {}: stresses "
      "use the given unit weight, wave speeds the void ratio",
      given.name, weight(given.value), short_text(mass.void_ratio),
      pretty(mass.grain_density, Dimension::density), weight(expected), pores));
}

/// Unit weight and saturation above the water table; each follows from the other.
void resolve_moist_ground(const InputValues& inputs, const GroundOptions& o, const PackingMass& mass,
                          GroundCase& c) {
  const Number& given = o.unit_weight;
  const double share_of_water = inputs.within(Input::saturation);
  if (!given.given()) {
    c.saturation = share_of_water;
    c.ground.unit_weight = mass.unit_weight(share_of_water);
    add_sentence(c.assumptions,
                 fmt::format("unit weight of {}: grains of {} at this void ratio, with {} % of the pores "
                             "filled with water; change it with --unit-weight",
                             weight(c.ground.unit_weight), pretty(mass.grain_density, Dimension::density),
                             short_text(100 * share_of_water, 3)));
    return;
  }
  c.ground.unit_weight = require_positive(given.name, given.value, "N/m3");
  if (inputs.given(Input::saturation)) {
    c.saturation = share_of_water;
    note_contradiction(given, mass.unit_weight(share_of_water), "this saturation", mass, c.validity);
    return;
  }
  const double implied = mass.saturation(given.value);
  c.saturation = std::min(std::max(implied, 0.0), 1.0);
  note_contradiction(given, mass.unit_weight(c.saturation),
                     implied > 1 ? "all pores full" : "all pores empty", mass, c.validity);
  add_sentence(c.assumptions,
               fmt::format("{} % of the pores above the water table are water, from the unit weight; "
                           "change it with --saturation",
                           short_text(100 * c.saturation, 3)));
}

void resolve_wet_ground(const GroundOptions& o, const PackingMass& mass, GroundCase& c) {
  if (!o.water_table.given())
    return;
  c.ground.water_table = o.water_table.value;
  const double full = mass.unit_weight(1);
  if (o.saturated_unit_weight.given()) {
    c.ground.saturated_unit_weight = o.saturated_unit_weight.value;
    note_contradiction(o.saturated_unit_weight, full, "all pores full", mass, c.validity);
    return;
  }
  c.ground.saturated_unit_weight = full;
  add_sentence(c.assumptions,
               fmt::format("saturated unit weight of {}: grains of {} at this void ratio with all "
                           "pores full; change it with --saturated-unit-weight",
                           weight(full), pretty(mass.grain_density, Dimension::density)));
}

} // namespace

void add_ground(Command& command, GroundOptions& o, const std::vector<Need>& in_ground) {
  std::vector<Need> below_water = in_ground;
  below_water.push_back({"--water-table --table", "--water-table, below which it applies"});
  command.add(
      ground_group,
      {{.name = "--unit-weight",
        .value = number_without_default(o.unit_weight),
        .meaning =
            "Unit weight above the water table, with pore water; by default from grain density and void "
            "ratio",
        .needs = in_ground,
        .synonyms = {{"gamma gammad gammasat bulkunitweight"}}},
       {.name = "--saturated-unit-weight",
        .value = number_without_default(o.saturated_unit_weight),
        .meaning = "Unit weight below the water table; by default from grain density and void ratio",
        .needs = below_water},
       {.name = "--water-table",
        .value = number_without_default(o.water_table),
        .meaning = "Depth of the water table; negative for water above the ground; by default none (dry)",
        .needs = in_ground,
        .synonyms = {{"gwt waterlevel groundwater"}}},
       {.name = "--surcharge",
        .value = number(o.surcharge),
        .meaning = "Pressure on the surface of the ground",
        .needs = in_ground},
       {.name = "--water-unit-weight",
        .value = number(o.water_unit_weight),
        .meaning = "Unit weight of the water",
        .needs = below_water}});
}

GroundCase resolve_ground(const InputValues& inputs, const GroundOptions& o) {
  GroundCase c;
  constexpr double any_stress = 1e5; // the density does not depend on it
  const PackingMass mass{.grain_density = inputs.within(Input::grain_density),
                         .void_ratio = state_of(inputs, {any_stress, any_stress}).void_ratio};
  const Number& k0 = o.earth_pressure_at_rest;
  estimate::require_within(estimate::row_of(Input::k0), k0.value, k0.name);
  c.ground.earth_pressure_at_rest = k0.value;
  c.ground.surcharge = require_non_negative(o.surcharge.name, o.surcharge.value, "Pa");
  c.ground.water_unit_weight = require_positive(o.water_unit_weight.name, o.water_unit_weight.value, "N/m3");
  resolve_moist_ground(inputs, o, mass, c);
  resolve_wet_ground(o, mass, c);
  if (!k0.given())
    c.assumptions.push_back({.name = k0.name, .value = short_text(k0.value), .number = k0.value});
  return c;
}

InputValues values_in_ground(const InputValues& inputs, const GroundCase& ground, double depth) {
  InputValues values = inputs;
  values.set_stresses(stress::stress_at(ground.ground, depth).effective);
  const auto& table = ground.ground.water_table;
  values.give(Input::saturation, table && depth > *table ? 1.0 : ground.saturation);
  return values;
}

} // namespace granum::cli
