// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/elastic/waves.hpp>

#include <granum/elastic/isotropic.hpp>

#include "unit.hpp"

using namespace granum::elastic;

namespace {

constexpr double GPa = 1e9, MPa = 1e6;
constexpr SaturatedPores sand{
    .grain_bulk_modulus = 37 * GPa, .fluid_bulk_modulus = 2.18 * GPa, .void_ratio = 0.7};

} // namespace

TEST_CASE("saturation: an isotropic skeleton has the bulk modulus of the usual equation, and its own G") {
  const double K = 150 * MPa, G = 100 * MPa, n = 0.7 / 1.7;
  const TransverselyIsotropic wet =
      saturated(transversely_isotropic(Isotropic::from_bulk_and_shear(K, G)), sand);
  // K_sat/(K_s - K_sat) = K/(K_s - K) + K_f/(n (K_s - K_f))
  const double K_s = sand.grain_bulk_modulus, K_f = sand.fluid_bulk_modulus;
  const double ratio = K / (K_s - K) + K_f / (n * (K_s - K_f));
  CHECK(std::abs(wet.bulk_modulus() / (K_s * ratio / (1 + ratio)) - 1) < 1e-14);
  CHECK(wet.C44 == G);
  CHECK(std::abs(wet.C66() / G - 1) < 1e-12);
  CHECK(std::abs(wet.C11 / wet.C33 - 1) < 1e-14);
}

TEST_CASE(
    "saturation: an anisotropic skeleton under equal pressure inside and outside strains as the solid") {
  const TransverselyIsotropic skeleton{
      .C11 = 300 * MPa, .C33 = 420 * MPa, .C12 = 90 * MPa, .C13 = 110 * MPa, .C44 = 110 * MPa};
  const TransverselyIsotropic wet = saturated(skeleton, sand);
  // Undrained strain e with the pore pressure u it raises: total stress = C e + a u, and the fluid's content
  // stays: u = M (a . e), with a = (a_h, a_h, a_v).
  const double K_s = sand.grain_bulk_modulus;
  const double a_h = 1 - (300 + 90 + 110) * MPa / (3 * K_s), a_v = 1 - (110 + 110 + 420) * MPa / (3 * K_s);
  const double M = (wet.C13 - skeleton.C13) / (a_h * a_v);
  CHECK(std::abs((wet.C33 - skeleton.C33) / (a_v * a_v * M) - 1) < 1e-12);
  CHECK(std::abs((wet.C11 - skeleton.C11) / (a_h * a_h * M) - 1) < 1e-12);
  CHECK(std::abs((wet.C12 - skeleton.C12) / (a_h * a_h * M) - 1) < 1e-12);
  // A pressure p on all sides and in the pores compresses solid and pores alike, by p/K_s: the fluid of the
  // pores n (1/K_f - 1/K_s) p must then have flown in, which is p/M less what the strain a . e displaces.
  const double n = 0.7 / 1.7;
  const double strain = 1 / (3 * K_s); // of each direction, per p
  const double inflow = 1 / M - (2 * a_h + a_v) * strain;
  CHECK(std::abs(inflow / (n * (1 / sand.fluid_bulk_modulus - 1 / K_s)) - 1) < 1e-12);
}

TEST_CASE("saturation: air rules the mixture but for the last per cent") {
  CHECK(std::abs(water_and_air_bulk_modulus(1) / (2.18 * GPa) - 1) < 1e-14);
  CHECK(water_and_air_bulk_modulus(0) == doctest::Approx(0.142 * MPa));
  CHECK(water_and_air_bulk_modulus(0.99) < 15 * MPa);
  CHECK_THROWS_AS((void)water_and_air_bulk_modulus(1.1), InvalidArgument);
  SaturatedPores none = sand;
  none.void_ratio = 0;
  CHECK_THROWS_AS((void)saturated({}, none), InvalidArgument);
}

TEST_CASE("saturation: the degree of saturation derived from the mass is recovered") {
  for (const double e : {0.45, 0.7, 1.1})
    for (const double share : {0.0, 0.3, 1.0, 1.2}) {
      const double rho =
          bulk_density({.grain_density = 2650, .void_ratio = e, .pore_density = share * water_density});
      CHECK(std::abs(saturation_of_bulk_density(rho, 2650, e) - share) < 1e-13);
    }
  CHECK(saturation_of_bulk_density(1000, 2650, 0.7) < 0);
  CHECK(water_density == relative(998.2, 3e-4)); // of water of 20 degrees Celsius
  CHECK_THROWS_AS((void)saturation_of_bulk_density(0, 2650, 0.7), InvalidArgument);
  CHECK_THROWS_AS((void)saturation_of_bulk_density(1800, -1, 0.7), InvalidArgument);
  CHECK_THROWS_AS((void)saturation_of_bulk_density(1800, 2650, 0), InvalidArgument);
}
