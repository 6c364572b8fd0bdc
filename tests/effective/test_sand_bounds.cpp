// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/sand_bounds.hpp>

#include <doctest/doctest.h>

#include <granum/core/error.hpp>

#include "relative.hpp"

using namespace granum;
using namespace granum::effective;

namespace {

constexpr contact::GrainMaterial quartz{45e9, 0.06};

Sand sand_of(double porosity, double pressure = 20e6) {
  return {.end_member = {quartz, 0.4, 8.6, pressure}, .no_slip_share = 1, .porosity = porosity};
}

long double mineral_bulk_modulus() { return 2 * 45e9L * (1 + 0.06L) / (3 * (1 - 2 * 0.06L)); }

/// The bound as it is printed: 1/(s/(a+c) + (1-s)/(b+c)) - c.
double printed(long double a, long double b, long double s, long double c) {
  return static_cast<double>(1 / (s / (a + c) + (1 - s) / (b + c)) - c);
}

long double zeta(long double K, long double G) { return G / 6 * (9 * K + 8 * G) / (K + 2 * G); }

} // namespace

TEST_CASE("sand bounds: the printed formulas") {
  const long double K_s = mineral_bulk_modulus(), G_s = 45e9;
  for (const double porosity : {0.01, 0.1, 0.2, 0.3, 0.39}) {
    const IsotropicModuli end = hertz_mindlin(sand_of(0.1).end_member);
    const long double K = end.bulk_modulus, G = end.shear_modulus, s = porosity / 0.4L;
    const IsotropicModuli soft = soft_sand(sand_of(porosity)), stiff = stiff_sand(sand_of(porosity));
    CHECK(soft.bulk_modulus == relative(printed(K, K_s, s, 4 * G / 3), 1e-14));
    CHECK(soft.shear_modulus == relative(printed(G, G_s, s, zeta(K, G)), 1e-14));
    CHECK(stiff.bulk_modulus == relative(printed(K, K_s, s, 4 * G_s / 3), 1e-14));
    CHECK(stiff.shear_modulus == relative(printed(G, G_s, s, zeta(K_s, G_s)), 1e-14));
    CHECK(soft.bulk_modulus < stiff.bulk_modulus);
    CHECK(soft.shear_modulus < stiff.shear_modulus);
    const IsotropicModuli below = sand_below(end, 0.4, quartz, porosity);
    CHECK(below.bulk_modulus == soft.bulk_modulus);
    CHECK(below.shear_modulus == soft.shear_modulus);
  }
}

TEST_CASE("sand bounds: exact at the ends and without pressure") {
  const IsotropicModuli end = hertz_mindlin(sand_of(0.4).end_member);
  for (const auto& bound : {soft_sand, stiff_sand}) {
    CHECK(bound(sand_of(0.4)).bulk_modulus == end.bulk_modulus);
    CHECK(bound(sand_of(0.4)).shear_modulus == end.shear_modulus);
    CHECK(bound(sand_of(0)).shear_modulus == 45e9);
    CHECK(bound(sand_of(0)).bulk_modulus == relative(static_cast<double>(mineral_bulk_modulus()), 1e-15));
    CHECK(bound(sand_of(0.4, 0)).bulk_modulus == 0);
    CHECK(bound(sand_of(0, 0)).shear_modulus == 45e9);
  }
  CHECK(soft_sand(sand_of(0.2, 0)).bulk_modulus == 0);
  CHECK(soft_sand(sand_of(0.2, 0)).shear_modulus == 0);
  // Stiff at p = 0: the mineral with empty pores of that share.
  const long double c = 4 * 45e9L / 3;
  CHECK(stiff_sand(sand_of(0.2, 0)).bulk_modulus ==
        relative(printed(0, mineral_bulk_modulus(), 0.5L, c), 1e-14));
  CHECK(soft_sand(sand_of(0.2, 1e-300)).shear_modulus > 0);
}

TEST_CASE("sand bounds: above the critical porosity there is no such sand") {
  CHECK_THROWS_AS((void)soft_sand(sand_of(0.41)), InvalidArgument);
  CHECK_THROWS_AS((void)stiff_sand(sand_of(0.8)), InvalidArgument);
  CHECK_THROWS_AS((void)soft_sand(sand_of(-0.1)), InvalidArgument);
  Sand incompressible = sand_of(0.2);
  incompressible.end_member.grain.poisson_ratio = 0.5;
  CHECK_THROWS_AS((void)soft_sand(incompressible), InvalidArgument);
}
