// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>

#include <limits>

#include <granum/core/units.hpp>
#include <granum/elastic/waves.hpp>
#include <granum/stress/stress.hpp>

#include "bindings.hpp"
#include "moduli.hpp"
#include "rows.hpp"

namespace granum::python {

namespace {

struct GroundRow {
  double total_v = nan, total_h = nan, pore_pressure = nan, stress_v = nan, stress_h = nan;
};

/// Places of the keywords of ground_stress, and of its columns.
enum : std::size_t {
  depth_at,
  unit_weight_at,
  saturated_unit_weight_at,
  water_table_at,
  water_unit_weight_at,
  earth_pressure_at_rest_at,
  surcharge_at
};

py::object ground_stress(const Arguments& a) {
  const bool water = a.given(water_table_at);
  if (water && !a.given(saturated_unit_weight_at))
    throw py::type_error("ground_stress() with water_table needs saturated_unit_weight");
  return rows_of(a, GroundRow{}, [water](const double* x, Notes&) {
    stress::Ground ground{.unit_weight = x[unit_weight_at],
                          .saturated_unit_weight = x[saturated_unit_weight_at],
                          .water_unit_weight = x[water_unit_weight_at],
                          .earth_pressure_at_rest = x[earth_pressure_at_rest_at],
                          .surcharge = x[surcharge_at]};
    if (water)
      ground.water_table = x[water_table_at];
    const stress::GroundStress found = stress::stress_at(ground, x[depth_at]);
    return GroundRow{.total_v = found.total.v,
                     .total_h = found.total.h,
                     .pore_pressure = found.pore_pressure,
                     .stress_v = found.effective.v,
                     .stress_h = found.effective.h};
  });
}

void bind_ground_stress(py::module_& module) {
  result_class<GroundRow>(
      module, "GroundStress",
      "Stresses in level ground, compression positive: effective, total, and of the water.")
      .show("stress_v", "Effective vertical stress [Pa].", &GroundRow::stress_v)
      .show("stress_h", "Effective horizontal stress [Pa].", &GroundRow::stress_h)
      .show("total_v", "Total (grains and water), vertical [Pa].", &GroundRow::total_v)
      .show("total_h", "Total (grains and water), horizontal [Pa].", &GroundRow::total_h)
      .show("pore_pressure", "u [Pa].", &GroundRow::pore_pressure);
  const auto of_water = [](Keyword keyword) { // its default is the weight of water
    keyword = keyword.or_none();
    keyword.number = elastic::water_density * standard_gravity;
    return keyword;
  };
  define(
      module, "ground_stress",
      {column("depth", "Depth below the surface, >= 0 [m]."),
       column("unit_weight", "Unit weight above the water table, including pore water, >= 0 [N/m3]."),
       of_water(column(
           "saturated_unit_weight",
           "Unit weight below the water table, at least that of water [N/m3]; required with water_table.")),
       column("water_table",
              "Its depth [m], negative for water above the ground; without it the ground is dry.")
           .or_none(),
       of_water(
           column("water_unit_weight",
                  "Unit weight of the water, > 0 [N/m3]; default: water at 20 degrees Celsius, 9787 N/m3.")),
       column("earth_pressure_at_rest", "K_0, horizontal over vertical effective stress, > 0 [1]."),
       column("surcharge", "Pressure on the surface, >= 0 [Pa].").or_number(0), strict_keyword()},
      {"Total stress, pore pressure and effective stress in level ground.", "GroundStress",
       "For a number out of range; arrays: under strict.", "Water at rest, no suction above its table.",
       "stress::stress_at", "stress/stress.hpp"},
      &ground_stress);
}

constexpr std::pair<const char*, stress::ShearPath> paths[] = {{"txc", stress::ShearPath::txc},
                                                               {"rtxc", stress::ShearPath::rtxc},
                                                               {"rtxe", stress::ShearPath::rtxe},
                                                               {"txe", stress::ShearPath::txe}};

void bind_paths(py::module_& module) {
  const char* const words = "{\"txc\", \"rtxc\", \"rtxe\", \"txe\"}";
  define(module, "stress_on_path",
         {required("path", words, "Triaxial compression, reduced compression, reduced extension, extension."),
          column("pressure", "Isotropic stress > 0 at the start of the path [Pa].")
              .called("stress at the start of the path"),
          column("eta", "q/p', in [0, 3) in compression, in (-3/2, 0] in extension [1]."), strict_keyword()},
         {"The stresses at which a triaxial test reaches a stress ratio.", "AxialStress",
          "For another path, or a number out of range; arrays: under strict.", "[Chung2014]",
          "stress::stress_on_path", "stress/stress.hpp"},
         [](const Arguments& a) {
           return rows_of(a, AxialStressRow{}, [path = a.choice(0, paths)](const double* x, Notes&) {
             const stress::AxialStress found = stress::stress_on_path(path, x[0], x[1]);
             return AxialStressRow{found.v, found.h};
           });
         });
  define(module, "failure_ratio",
         {required("path", words, "As for stress_on_path()."),
          column("friction_angle", "Of the material, in (0, pi/2) [rad].")},
         {"The stress ratio q/p' at which a material without cohesion fails on a path.",
          "float or ndarray\n    eta [1], negative in extension.",
          "For another path, or the first angle out of range.", "", "stress::failure_ratio",
          "stress/stress.hpp"},
         [](const Arguments& a) {
           return numbers_of_rows(
               a, [path = a.choice(0, paths)](const double* x) { return stress::failure_ratio(path, x[0]); });
         });
}

} // namespace

void bind_ground(py::module_& module) {
  bind_ground_stress(module);
  bind_paths(module);
}

} // namespace granum::python
