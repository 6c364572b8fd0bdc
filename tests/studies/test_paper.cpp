// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/paper/paper.hpp"

#include "unit.hpp"

using namespace granum::studies;
using granum::contact::Shape;
using granum::triaxial::Density;

// The numbers were typed from Tables 2, 4 and 5; these relations hold among them and catch most slips.
TEST_CASE("printed exponents add up, G_vh mirrors G_hv, and angles and structure are ordered") {
  CHECK_FALSE(printed(Shape::power_law, Density::dense).has_value());
  for (const Shape shape : {Shape::cone, Shape::sphere, Shape::flat}) {
    const PrintedSpecimen dense = printed(shape, Density::dense).value(),
                          loose = printed(shape, Density::loose).value();
    for (const PrintedSpecimen& p : {dense, loose}) {
      for (const PrintedFit& fit : {p.hv, p.vh})
        CHECK(std::abs(*fit.m + *fit.n - fit.s) < 0.0025);
      CHECK(std::abs(*p.hv.m - *p.vh.n) < 0.014);
      CHECK(std::abs(*p.hv.n - *p.vh.m) < 0.014);
      CHECK(std::abs(p.hv.s - p.vh.s) < 0.0035);
      CHECK(std::abs(p.hv.C / p.vh.C - 1) < 0.002);
      CHECK(std::abs(p.hh.s - p.hv.s) < 0.036);
      CHECK(std::abs(p.hh.C / p.hv.C - 1) < 0.09);
      CHECK_FALSE(p.hh.m.has_value());
      // Compression (TXC, RTXC) fails at a smaller angle than extension (RTXE, TXE).
      CHECK(std::max(p.friction_angle[0], p.friction_angle[1]) <
            std::min(p.friction_angle[2], p.friction_angle[3]));
    }
    CHECK(loose.coordination_number < dense.coordination_number - 1.9);
    CHECK(loose.void_ratio > dense.void_ratio);
    CHECK(loose.hv.s > dense.hv.s + 0.16);
  }
  CHECK(printed(Shape::sphere, Density::loose)->friction_angle == std::array{26.1, 25.8, 28.3, 30.0});
  CHECK(printed(Shape::flat, Density::dense)->hv.C == 100.8);
}
