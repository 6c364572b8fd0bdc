// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/stress/stress.hpp>

#include "unit.hpp"

using namespace granum::stress;

namespace {

constexpr double ulps = 8 * std::numeric_limits<double>::epsilon();

const Ground sand{.unit_weight = 17e3,
                  .saturated_unit_weight = 20e3,
                  .water_table = 2,
                  .water_unit_weight = 10e3,
                  .earth_pressure_at_rest = 0.5,
                  .surcharge = 15e3};

/// Slices of the weight above, added up: not the formula of the library.
double summed_weight(const Ground& g, double depth) {
  constexpr int slices = 4000;
  double sum = g.surcharge;
  for (int k = 0; k < slices; ++k) {
    const double middle = depth * (k + 0.5) / slices;
    sum +=
        (g.water_table && middle > *g.water_table ? g.saturated_unit_weight : g.unit_weight) * depth / slices;
  }
  return sum;
}

} // namespace

TEST_CASE("total stress is the weight above, and effective stress the part not carried by water") {
  for (const double depth : {0.0, 0.5, 2.0, 3.0, 12.0, 30.0}) {
    const GroundStress at = stress_at(sand, depth);
    CAPTURE(depth);
    CHECK(at.total.v == relative(summed_weight(sand, depth), 2e-3)); // one slice holds the water table
    CHECK(at.effective.v + at.pore_pressure == relative(at.total.v, ulps));
    CHECK(at.effective.h + at.pore_pressure == relative(at.total.h, ulps));
    CHECK(at.effective.h == relative(0.5 * at.effective.v, ulps));
    CHECK(at.effective.mean() == relative(at.effective.v * 2 / 3, ulps));  // (1 + 2 K_0)/3
    CHECK(at.total.deviator() == relative(at.effective.deviator(), ulps)); // water has no shear stress
  }
}

TEST_CASE("stresses by hand: 2 m of 17 kN/m3 over 20 kN/m3 in water, under 15 kPa") {
  const GroundStress at = stress_at(sand, 12);
  CHECK(at.total.v == relative(15e3 + 34e3 + 200e3, ulps));
  CHECK(at.pore_pressure == relative(100e3, ulps));
  CHECK(at.effective.v == relative(149e3, ulps));
  CHECK(at.total.h == relative(174.5e3, ulps));
}

TEST_CASE("effective stress does not depend on the water level above the ground") {
  Ground shallow = sand, deep = sand;
  shallow.water_table = 0;
  deep.water_table = -50;
  CHECK(stress_at(deep, 7).effective == stress_at(shallow, 7).effective);
  CHECK(stress_at(deep, 7).pore_pressure == relative(570e3, ulps));
  CHECK(stress_at(deep, 0).pore_pressure == relative(500e3, ulps));
}

TEST_CASE("dry ground: no water table, or one below") {
  Ground dry = sand, low = sand;
  dry.water_table.reset();
  dry.saturated_unit_weight = 0; // not asked for
  low.water_table = 100;
  CHECK(stress_at(dry, 30).effective == stress_at(low, 30).effective);
  CHECK(stress_at(dry, 30).total == stress_at(dry, 30).effective);
  CHECK(stress_at(dry, 0).effective.v == 15e3);
}

TEST_CASE("ground that cannot be is refused by name") {
  const auto refused = [](Ground ground, double depth, const char* name) {
    try {
      (void)stress_at(ground, depth);
    } catch (const InvalidArgument& error) {
      return std::string(error.what()).starts_with(name);
    }
    return false;
  };
  CHECK(refused(sand, -1, "depth"));
  Ground g = sand;
  g.saturated_unit_weight = 9e3;
  CHECK(refused(g, 1, "saturated_unit_weight - water_unit_weight"));
  g = sand;
  g.earth_pressure_at_rest = 0;
  CHECK(refused(g, 1, "earth_pressure_at_rest"));
  g = sand;
  g.unit_weight = -1;
  CHECK(refused(g, 1, "unit_weight"));
  g = sand;
  g.surcharge = -1;
  CHECK(refused(g, 1, "surcharge"));
  g = sand;
  g.water_table = std::numeric_limits<double>::infinity();
  CHECK(refused(g, 1, "water_table"));
}
