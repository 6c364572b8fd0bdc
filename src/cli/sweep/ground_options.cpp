// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/core.h>
#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/elastic/waves.hpp>

#include "depth.hpp"

namespace granum::cli {

namespace {

/// Relative difference between a given unit weight and that of void ratio and grain density that is not
/// reported.
constexpr double unit_weight_tolerance = 0.02;

} // namespace

std::vector<double> depths_of(const SweepOptions& o) {
  const std::string& text = o.ground.depth;
  const auto ends = ends_of_range(text);
  if (!ends)
    throw InvalidArgument(fmt::format("--depth = '{}' must be two depths, such as 0m..30m", text));
  const double first = parse_quantity("--depth", ends->front(), Dimension::length);
  const double last = parse_quantity("--depth", ends->back(), Dimension::length);
  require_non_negative("--depth", first, "m");
  if (!(last > first))
    throw InvalidArgument(fmt::format("--depth = '{}' must be the smaller depth, then the larger", text));
  return spread(first, last, o.points, false);
}

namespace {

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
void resolve_moist_ground(const SweepOptions& o, const PackingMass& mass, GroundCase& c) {
  const Number& given = o.ground.unit_weight;
  const double share_of_water = o.inputs.within(Input::saturation);
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
  if (o.inputs.given(Input::saturation)) {
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

void resolve_wet_ground(const SweepOptions& o, const PackingMass& mass, GroundCase& c) {
  const GroundOptions& g = o.ground;
  if (!g.water_table.given())
    return;
  c.ground.water_table = g.water_table.value;
  const double full = mass.unit_weight(1);
  if (g.saturated_unit_weight.given()) {
    c.ground.saturated_unit_weight = g.saturated_unit_weight.value;
    note_contradiction(g.saturated_unit_weight, full, "all pores full", mass, c.validity);
    return;
  }
  c.ground.saturated_unit_weight = full;
  add_sentence(c.assumptions,
               fmt::format("saturated unit weight of {}: grains of {} at this void ratio with all "
                           "pores full; change it with --saturated-unit-weight",
                           weight(full), pretty(mass.grain_density, Dimension::density)));
}

} // namespace

void add_ground_options(Command& command, GroundOptions& o) {
  const std::vector<Need> in_ground = {{"--depth --table", "--depth"}};
  const std::vector<Need> below_water = {{"--depth --table", "--depth"},
                                         {"--water-table --table", "--water-table, below which it applies"}};
  Value depth = text(o.depth, "FROM..TO");
  depth.joins_units = true;
  command.add(
      "Ground",
      {{.name = "--depth",
        .value = std::move(depth),
        .meaning =
            "Stiffness over depth in level ground, between two depths: 0m..30m; with V_s30, the travel "
            "time of a shear wave and the period 4 H/V_s",
        .excludes = {{"--path --from --to --eta --friction-angle --spacing --table --rungs --picture-of"}},
        .synonyms = {{"z"}}},
       {.name = "--layers",
        .value = path(o.layers, "FILE.csv"),
        .meaning =
            "Layers of the ground, one per row from its top_m down, with columns as for --table: e or D_r, "
            "unit_weight, saturated_unit_weight, k0, sand, S_r",
        .needs = {{"--depth", "--depth"}},
        .synonyms = {{"profile soil strata"}}},
       {.name = "--unit-weight",
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
       {.name = "--k0",
        .value = number(o.earth_pressure_at_rest),
        .meaning = "K_0, horizontal over vertical effective stress in the ground",
        .needs = {{"--depth --table --for", "--depth"}},
        .synonyms = {{"k0 ko"}}},
       {.name = "--surcharge",
        .value = number(o.surcharge),
        .meaning = "Pressure on the surface of the ground",
        .needs = in_ground},
       {.name = "--water-unit-weight",
        .value = number(o.water_unit_weight),
        .meaning = "Unit weight of the water",
        .needs = below_water}});
}

GroundCase resolve_ground(const SweepOptions& o) {
  GroundCase c;
  constexpr double any_stress = 1e5; // the density does not depend on it
  const PackingMass mass{.grain_density = o.inputs.within(Input::grain_density),
                         .void_ratio = state_of(o.inputs, {any_stress, any_stress}).void_ratio};
  const Number& k0 = o.ground.earth_pressure_at_rest;
  estimate::require_within(estimate::row_of(Input::k0), k0.value, k0.name);
  c.ground.earth_pressure_at_rest = k0.value;
  c.ground.surcharge = require_non_negative(o.ground.surcharge.name, o.ground.surcharge.value, "Pa");
  c.ground.water_unit_weight =
      require_positive(o.ground.water_unit_weight.name, o.ground.water_unit_weight.value, "N/m3");
  resolve_moist_ground(o, mass, c);
  resolve_wet_ground(o, mass, c);
  if (!k0.given())
    c.assumptions.push_back({.name = k0.name, .value = short_text(k0.value), .number = k0.value});
  return c;
}

} // namespace granum::cli
