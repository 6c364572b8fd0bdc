// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/sweep/normal_forces.hpp"

#include "unit.hpp"

using namespace granum::dem;

namespace {

/// Hertz' kernel as one that has no vector code of its own.
struct PlainSphere {
  contact::SphereKernel hertz;
  contact::NormalResponse operator()(double overlap) const noexcept { return hertz(overlap); }
  [[nodiscard]] PlainSphere of_pair_radius(double ratio) const noexcept {
    return {hertz.of_pair_radius(ratio)};
  }
};

} // namespace

TEST_CASE("a kernel without vector code of its own has the sizes of a pair") {
  const contact::SphereKernel hertz{2e9};
  CHECK(normal_response<VectorLevel::baseline>(PlainSphere{hertz}, 0, 0, 0).force == 0);
  for (const double ratio : {0.4, 1.0, 1.7})
    for (const double overlap : {1e-9, 1e-8, 1e-6}) {
      const contact::NormalResponse found =
          normal_response<VectorLevel::baseline>(PlainSphere{hertz}, overlap, overlap / ratio, 0);
      const contact::NormalResponse expected = hertz.of_pair_radius(ratio)(overlap);
      CHECK(found.force == relative(expected.force, 1e-15));
      CHECK(found.stiffness == relative(expected.stiffness, 1e-15));
    }
}
