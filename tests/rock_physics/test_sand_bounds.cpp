// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/rock_physics/cement.hpp>

#include <granum/rock_physics/sphere_packs.hpp>

#include "unit.hpp"

using rock_physics::soft_sand;
using rock_physics::SpherePacking;
using rock_physics::stiff_sand;

namespace {

/// Bulk modulus 36.6 and shear modulus 45 GPa.
constexpr SpherePacking packing{.shear_modulus = 45e9,
                                .poisson_ratio = (3 * 36.6 - 2 * 45) / (2 * (3 * 36.6 + 45)),
                                .porosity = 0.4,
                                .coordination_number = 8.6,
                                .pressure = 20e6};

/// Coated spheres under all-round strain: an inner sphere (share f, modulus inner) in a shell; the field of
/// the shell, u = A r + B/r^2, solved from the conditions at the interface. The bound is exact for it.
double coated_sphere_bulk(double inner, double shell, double shell_shear, double f) {
  // Inside u = r; at r^3 = f both u and the radial stress 3 K A - 4 G B/r^3 match.
  // A + B/f = 1 and 3 shell A - 4 shell_shear B/f = 3 inner.
  const double A = (3 * inner + 4 * shell_shear) / (3 * shell + 4 * shell_shear);
  const double B = f * (1 - A);
  return (3 * shell * A - 4 * shell_shear * B) / (3 * (A + B));
}

} // namespace

TEST_CASE("sand bounds: bulk moduli of coated spheres, shear moduli as the bounds are printed") {
  const auto end = rock_physics::hertz_mindlin(packing);
  const auto printed = [&](double f, double K, double G) {
    const double z = G / 6 * (9 * K + 8 * G) / (K + 2 * G);
    return 1 / (f / (end.shear_modulus + z) + (1 - f) / (45e9 + z)) - z;
  };
  for (const double porosity : {0.01, 0.1, 0.2, 0.3, 0.39}) {
    const double f = porosity / 0.4;
    CAPTURE(porosity);
    const auto soft = soft_sand(packing, porosity), stiff = stiff_sand(packing, porosity);
    CHECK(soft.bulk_modulus ==
          relative(coated_sphere_bulk(36.6e9, end.bulk_modulus, end.shear_modulus, 1 - f), 1e-14));
    CHECK(stiff.bulk_modulus == relative(coated_sphere_bulk(end.bulk_modulus, 36.6e9, 45e9, f), 1e-14));
    CHECK(soft.shear_modulus == relative(printed(f, end.bulk_modulus, end.shear_modulus), 1e-13));
    CHECK(stiff.shear_modulus == relative(printed(f, 36.6e9, 45e9), 1e-13));
  }
}

TEST_CASE("sand bounds: both end members exactly") {
  const auto end = rock_physics::hertz_mindlin(packing);
  for (const auto model : {soft_sand, stiff_sand}) {
    CHECK(model(packing, 0.4).bulk_modulus == end.bulk_modulus);
    CHECK(model(packing, 0.4).shear_modulus == end.shear_modulus);
    CHECK(model(packing, 0).bulk_modulus == relative(36.6e9, 4e-16));
    CHECK(model(packing, 0).shear_modulus == 45e9);
    // and continuously
    CHECK(model(packing, std::nextafter(0.4, 0)).bulk_modulus == relative(end.bulk_modulus, 1e-14));
    CHECK(model(packing, 1e-17).shear_modulus == relative(45e9, 1e-15));
  }
}

TEST_CASE("sand bounds: no pressure, no contacts, incompressible grains") {
  auto unloaded = packing, empty = packing;
  unloaded.pressure = 0;
  empty.coordination_number = 0;
  for (const auto& none : {unloaded, empty}) {
    CHECK(soft_sand(none, 0.2).bulk_modulus == 0);
    CHECK(soft_sand(none, 0.2).shear_modulus == 0);
    CHECK(soft_sand(none, 0).shear_modulus == 45e9);
    CHECK(stiff_sand(none, 0.2).bulk_modulus > 0);
  }
  auto soft = packing, nearly = packing;
  soft.poisson_ratio = 0.5;
  nearly.poisson_ratio = 0.5 - 1e-15;
  for (const auto model : {soft_sand, stiff_sand}) {
    CHECK(model(soft, 0.2).bulk_modulus == relative(model(nearly, 0.2).bulk_modulus, 1e-12));
    CHECK(model(soft, 0.2).shear_modulus == relative(model(nearly, 0.2).shear_modulus, 1e-12));
    CHECK(model(soft, 0).bulk_modulus == std::numeric_limits<double>::infinity());
  }
}

TEST_CASE("sand bounds: a porosity above the critical one is refused by its name") {
  auto solid = packing;
  solid.porosity = 0;
  for (const auto model : {soft_sand, stiff_sand}) {
    CHECK_THROWS_AS((void)model(packing, -0.1), InvalidArgument);
    CHECK_THROWS_AS((void)model(packing, std::numeric_limits<double>::quiet_NaN()), InvalidArgument);
    CHECK_THROWS_WITH_AS((void)model(packing, 0.8), doctest::Contains("porosity = "), InvalidArgument);
    CHECK_THROWS_AS((void)model(solid, 0), InvalidArgument);
  }
}
