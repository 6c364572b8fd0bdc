// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/elastic/waves.hpp>

#include "unit.hpp"

using namespace granum::elastic;

TEST_CASE("bulk density includes grains and pore fluid") {
  // mass of 1 m3 of solid in 1.6 m3, with 0.6 m3 of water
  CHECK(bulk_density({.grain_density = 2650, .void_ratio = 0.6, .pore_density = 1000}) ==
        relative((2650 + 600) / 1.6, 1e-15));
  CHECK(bulk_density({.grain_density = 2650, .void_ratio = 0}) == 2650);
  for (const GrainsAndPores& bad : {GrainsAndPores{.grain_density = 0, .void_ratio = 0.6},
                                    {.grain_density = 2650, .void_ratio = -0.1},
                                    {.grain_density = 2650, .void_ratio = 0.6, .pore_density = -1}})
    CHECK_THROWS_AS((void)bulk_density(bad), InvalidArgument);
}

TEST_CASE("isotropic speeds are those of the Christoffel matrix, and back") {
  for (const double nu : {-0.9, -0.3, 0.0, 0.25, 0.49}) {
    const Isotropic solid = Isotropic::from_shear_and_poisson(140e6, nu);
    const WaveSpeeds speeds = wave_speeds(solid, 1650);
    const PlaneWaves waves = plane_waves(voigt(solid), 1650, {0.2, -0.4, 0.5});
    CHECK(speeds.p == relative(waves.fastest.speed, 1e-13)); // the matrix loses digits near nu = 0.5
    CHECK(speeds.s == relative(waves.slowest.speed, 1e-13));
    // V_p/V_s = sqrt((2 - 2 nu)/(1 - 2 nu))
    CHECK(speeds.p / speeds.s == relative(std::sqrt((2 - 2 * nu) / (1 - 2 * nu)), 1e-14));
    CHECK(shear_modulus_from_speed(speeds.s, 1650) == relative(140e6, 1e-15));
    const Isotropic back = isotropic_from_speeds(speeds, 1650);
    CHECK(back.bulk_modulus() == relative(solid.bulk_modulus(), nu < -0.5 ? 1e-12 : 1e-14));
    CHECK(back.shear_modulus() == relative(140e6, 1e-15));
  }
  CHECK(shear_modulus_from_speed(0, 1650) == 0);
}

TEST_CASE("speeds that no solid has are refused") {
  const Isotropic sand = Isotropic::from_bulk_and_shear(190e6, 140e6);
  CHECK_THROWS_AS((void)wave_speeds(sand, 0), InvalidArgument);
  CHECK_THROWS_AS((void)wave_speeds(Isotropic::from_shear_and_poisson(1e6, 0.5), 1650), InvalidArgument);
  CHECK_THROWS_AS((void)shear_modulus_from_speed(-1, 1650), InvalidArgument);
  CHECK_THROWS_AS((void)shear_modulus_from_speed(100, std::nan("")), InvalidArgument);
  CHECK_THROWS_AS((void)isotropic_from_speeds({.p = 230, .s = 200}, 1650), InvalidArgument); // K < 0
  CHECK_NOTHROW((void)isotropic_from_speeds({.p = 231, .s = 200}, 1650)); // sqrt(4/3) 200 = 230.94
  CHECK_THROWS_AS((void)isotropic_from_speeds({.p = 231, .s = 0}, 1650), InvalidArgument);
}
