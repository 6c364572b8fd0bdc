// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/plan/plan.hpp"

#include <string>

#include <doctest/doctest.h>
#include <granum/sizes/distribution.hpp>

using namespace granum;
using namespace granum::studies;

namespace {

std::string cost_of(const char* sizes) {
  Scene scene;
  scene.grain.sizes = sizes::parse_distribution(sizes);
  return cost_of_sizes(scene);
}

} // namespace

TEST_CASE("sizes that span up to 1:5 have no note on their cost, wider ones do") {
  for (const char* sizes : {"equal", "uniform:1:3", "lognormal:0.25", "power-law:3:5", "bidisperse:5:0.1"}) {
    CAPTURE(sizes);
    CHECK(cost_of(sizes) == "");
  }
  for (const char* sizes : {"uniform:1:6", "power-law:3:6", "bidisperse:6:0.1"}) {
    CAPTURE(sizes);
    CHECK(cost_of(sizes).starts_with("grain.sizes span 1:6: "));
  }
  CHECK(cost_of("power-law:3:10").find("1:10: ") != std::string::npos);
  CHECK(cost_of("power-law:3:10").find("needs 760 grains or more") != std::string::npos);
}
