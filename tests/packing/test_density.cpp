// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/packing/assembly.hpp>

#include "sample_packings.hpp"
#include "unit.hpp"

TEST_CASE("solid fractions of the lattices") {
  using std::numbers::pi;
  const auto fraction = [](const samples::Lattice& kind) {
    return solid_fraction(samples::lattice(kind, {.radius = 0.3}));
  };
  CHECK(fraction(samples::simple_cubic) == doctest::Approx(pi / 6).epsilon(1e-14));
  CHECK(fraction(samples::body_centred) == doctest::Approx(pi * std::sqrt(3) / 8).epsilon(1e-14));
  CHECK(fraction(samples::face_centred) == doctest::Approx(pi / std::sqrt(18)).epsilon(1e-14));
  CHECK(fraction(samples::hexagonal) == doctest::Approx(pi / std::sqrt(18)).epsilon(1e-14));
}

TEST_CASE("unequal radii add their own volumes, and the void ratio is the complement") {
  packing::Assembly a;
  a.cell = {{{2, 0.5, 0}, {0, 1, 0}, {0, 0, 1}}}; // skewed, volume 2
  a.position = {{0, 0, 0}, {0.5, 0.5, 0.5}};
  a.radius = {0.5, 0.25};
  const double solid = 4 * std::numbers::pi / 3 * (1.0 / 8 + 1.0 / 64) / 2;
  CHECK(solid_fraction(a) == doctest::Approx(solid).epsilon(1e-15));
  CHECK(void_ratio(a) == doctest::Approx(1 / solid - 1).epsilon(1e-15));
  a.position.clear();
  a.radius.clear();
  CHECK(solid_fraction(a) == 0);
  CHECK_THROWS_AS(static_cast<void>(void_ratio(a)), InvalidArgument);
}
