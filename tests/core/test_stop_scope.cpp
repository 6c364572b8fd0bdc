// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/core/stop.hpp>

#include <functional>
#include <thread>

#include <granum/effective/batch.hpp>
#include <granum/fabric/estimates.hpp>
#include <granum/fabric/orientation.hpp>
#include <granum/sizes/distribution.hpp>

#include "unit.hpp"

namespace {

const StopRequest always = [] { return true; }, never = [] { return false; };

} // namespace

TEST_CASE("a stop request holds in its scope, in its thread, until an inner one replaces it") {
  CHECK_NOTHROW(stop_point());
  {
    const StopScope stopped(always);
    CHECK_THROWS_AS(stop_point(), Stopped);
    {
      const StopScope inner(never);
      CHECK_NOTHROW(stop_point());
    }
    CHECK_THROWS_AS(stop_point(), Stopped);
    CHECK_THROWS_AS(stop_point(512), Stopped);
    CHECK_NOTHROW(stop_point(513));
    std::thread([] { CHECK_NOTHROW(stop_point()); }).join();
  }
  CHECK_NOTHROW(stop_point());
}

TEST_CASE("work that may last ends on a stop request") {
  const std::vector<Vec3> normals = fabric::sample_normals(0.1, 100, 1);
  const std::vector<double> pressure(1000, 100e3);
  std::vector<double> bulk(pressure.size()), shear(pressure.size());
  const sizes::Distribution lognormal = sizes::parse_distribution("lognormal:0.35");
  const std::function<void()> works[] = {
      [] { (void)fabric::sample_normals(0.1, 100, 1); },
      [&] { (void)sizes::sample_radii(lognormal, 100, 1); },
      [&] { (void)sizes::sample_radii(lognormal, 100, 1, sizes::Drawing::plain); },
      [&] { (void)fabric::estimate_anisotropy_by_likelihood(normals); },
      [&] { (void)fabric::test_isotropy(normals); },
      [&] {
        (void)effective::uniform_strain({.law = contact::PowerLaw::sphere({30e9, 0.15}, 0.5e-3),
                                         .tangential_ratio = 0.9,
                                         .radius = 0.5e-3,
                                         .pressure = pressure,
                                         .coordination_number = 5,
                                         .porosity = 0.4},
                                        {bulk, shear});
      }};
  for (const auto& work : works) {
    CAPTURE(&work - works);
    CHECK_NOTHROW(work());
    const StopScope scope(always);
    CHECK_THROWS_AS(work(), Stopped);
  }
}
