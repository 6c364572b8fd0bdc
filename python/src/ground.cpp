// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <limits>

#include <granum/core/error.hpp>
#include <granum/core/units.hpp>
#include <granum/elastic/saturation.hpp>
#include <granum/stress/ground.hpp>
#include <granum/stress/shear_path.hpp>

#include "bindings.hpp"
#include "docstrings.hpp"
#include "keywords.hpp"
#include "moduli.hpp"

namespace granum::python {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct GroundRow {
  double total_v = nan, total_h = nan, pore_pressure = nan, stress_v = nan, stress_h = nan;
};

enum : std::size_t {
  depth_at,
  unit_weight_at,
  saturated_unit_weight_at,
  water_table_at,
  water_unit_weight_at,
  earth_pressure_at_rest_at,
  surcharge_at,
  strict_at
};

py::object ground_stress(const Arguments& a) {
  const bool water = a.given(water_table_at);
  const auto column = [&a](std::size_t at, const char* name, double otherwise) {
    return a.given(at) ? Argument{name, a[at]} : Argument{name, otherwise};
  };
  const Argument dry_weight{"unit_weight", a[unit_weight_at]};
  if (water && !a.given(saturated_unit_weight_at))
    throw py::type_error("ground_stress() with water_table needs saturated_unit_weight");
  const double water_weight = elastic::water_density * standard_gravity;
  const Argument columns[] = {{"depth", a[depth_at]},
                              dry_weight,
                              column(saturated_unit_weight_at, "saturated_unit_weight", water_weight),
                              column(water_table_at, "water_table", 0),
                              column(water_unit_weight_at, "water_unit_weight", water_weight),
                              {"earth_pressure_at_rest", a[earth_pressure_at_rest_at]},
                              column(surcharge_at, "surcharge", 0)};
  return py::cast(answer_rows(columns, a.flag(strict_at), GroundRow{}, [water](const double* x, Notes&) {
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
  }));
}

stress::ShearPath shear_path_of(const std::string& text) {
  for (const stress::ShearPath path : stress::all_shear_paths) {
    std::string known(stress::name(path));
    std::transform(known.begin(), known.end(), known.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (text == known)
      return path;
  }
  throw InvalidArgument("path is one of txc, rtxc, rtxe, txe, not " + text);
}

void bind_paths(py::module_& module) {
  define(module, {"stress_on_path",
                  {{"path"}, {"pressure"}, {"eta"}, {"strict", "False"}},
                  [](const Arguments& a) {
                    const stress::ShearPath path = shear_path_of(a.text(0));
                    const Argument columns[] = {{"pressure", a[1], "start"}, {"eta", a[2]}};
                    return py::cast(
                        answer_rows(columns, a.flag(3), AxialStressRow{}, [path](const double* x, Notes&) {
                          const stress::AxialStress found = stress::stress_on_path(path, x[0], x[1]);
                          return AxialStressRow{found.v, found.h};
                        }));
                  },
                  std::string(R"(The stresses at which a triaxial test reaches a stress ratio.

Parameters
----------
path : {"txc", "rtxc", "rtxe", "txe"}
    Triaxial compression, reduced compression, reduced extension, extension.
pressure : array_like
    Isotropic stress > 0 at the start of the path [Pa].
eta : array_like
    q/p', in [0, 3) in compression, in (-3/2, 0] in extension [1].
strict : bool
    Raise at the first element that is refused, instead of NaN and a message in `errors`.

Returns
-------
AxialStress
)") + raises_invalid("For another path, or a number out of range; arrays: under strict.") +
                      notes("[Chung2014]", "stress::stress_on_path", "stress/shear_path.hpp")});
  define(module, {"failure_ratio",
                  {{"path"}, {"friction_angle"}},
                  [](const Arguments& a) {
                    const stress::ShearPath path = shear_path_of(a.text(0));
                    const Argument columns[] = {{"friction_angle", a[1]}};
                    return computed(answer_rows<double>(columns, true, 0.0,
                                                        [path](const double* x, Notes&) {
                                                          return stress::failure_ratio(path, x[0]);
                                                        }),
                                    [](double ratio) { return ratio; });
                  },
                  std::string(R"(The stress ratio q/p' at which a material without cohesion fails on a path.

Parameters
----------
path : {"txc", "rtxc", "rtxe", "txe"}
    As for stress_on_path().
friction_angle : array_like
    Of the material, in (0, pi/2) [rad].

Returns
-------
float or ndarray
    eta [1], negative in extension.
)") + raises_invalid("For another path, or the first angle out of range.") +
                      notes("", "stress::failure_ratio", "stress/shear_path.hpp")});
}

} // namespace

void bind_ground(py::module_& module) {
  auto type = result_class<GroundRow>(
      module, "GroundStress",
      "Stresses in level ground, compression positive: effective, total, and of the water.");
  show_member<GroundRow>(type, "stress_v", offsetof(GroundRow, stress_v), "Effective vertical stress [Pa].");
  show_member<GroundRow>(type, "stress_h", offsetof(GroundRow, stress_h),
                         "Effective horizontal stress [Pa].");
  show_member<GroundRow>(type, "total_v", offsetof(GroundRow, total_v),
                         "Total (grains and water), vertical [Pa].");
  show_member<GroundRow>(type, "total_h", offsetof(GroundRow, total_h),
                         "Total (grains and water), horizontal [Pa].");
  show_member<GroundRow>(type, "pore_pressure", offsetof(GroundRow, pore_pressure), "u [Pa].");
  define(module,
         {"ground_stress",
          {{"depth"},
           {"unit_weight"},
           {"saturated_unit_weight", "None"},
           {"water_table", "None"},
           {"water_unit_weight", "None"},
           {"earth_pressure_at_rest"},
           {"surcharge", "0.0"},
           {"strict", "False"}},
          &ground_stress,
          std::string(R"(Total stress, pore pressure and effective stress in level ground.

Parameters
----------
depth : array_like
    Depth below the surface, >= 0 [m].
unit_weight : array_like
    Unit weight above the water table, including pore water, >= 0 [N/m3].
saturated_unit_weight : array_like, optional
    Unit weight below the water table, at least that of water [N/m3]; required with water_table.
water_table : array_like, optional
    Its depth [m], negative for water above the ground; without it the ground is dry.
water_unit_weight : array_like, optional
    Unit weight of the water, > 0 [N/m3]; default: water at 20 degrees Celsius, 9787 N/m3.
earth_pressure_at_rest : array_like
    K_0, horizontal over vertical effective stress, > 0 [1].
surcharge : array_like
    Pressure on the surface, >= 0 [Pa].
strict : bool
    Raise at the first element that is refused, instead of NaN and a message in `errors`.

Returns
-------
GroundStress
)") + raises_invalid("For a number out of range; arrays: under strict.") +
              notes("Water at rest, no suction above its table.", "stress::stress_at", "stress/ground.hpp")});
  bind_paths(module);
}

} // namespace granum::python
