// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/rock_physics/sphere_packs.hpp>

#include "states.hpp"
#include "unit.hpp"

using rock_physics::BondedPacking;
using rock_physics::digby;
using test::with;

namespace {

/// Bulk modulus 37 and shear modulus 44 GPa.
constexpr BondedPacking bonded{.shear_modulus = 44e9,
                               .poisson_ratio = (3 * 37.0 - 2 * 44) / (2 * (3 * 37.0 + 44)),
                               .porosity = 0.36,
                               .coordination_number = 9,
                               .pressure = 20e6,
                               .bond_radius_ratio = 0.2};

/// The root of d^3 + 3/2 b^2 d = q by bisection in long double.
long double bisected(long double b, long double q) {
  long double low = 0, high = std::cbrt(q);
  for (int i = 0; i < 200; ++i) {
    const long double d = (low + high) / 2;
    (d * d * d + 1.5L * b * b * d < q ? low : high) = d;
  }
  return low;
}

} // namespace

TEST_CASE("digby: the published example") {
  const auto m = digby(bonded);
  // Printed with 9 digits.
  CHECK(m.bulk_modulus == relative(5.81155426e9, 1e-9));
  CHECK(m.shear_modulus == relative(8.51375906e9, 1e-9));
}

TEST_CASE("digby: the contact radius against bisection, from strong bonds to strong pressure") {
  int tried = 0;
  for (double pressure = 1e-12; pressure <= 1e12; pressure *= 10)
    for (double b = 1e-8; b < 1; b *= 10, ++tried) {
      const auto p =
          with(with(bonded, &BondedPacking::pressure, pressure), &BondedPacking::bond_radius_ratio, b);
      using Long = long double;
      const Long pi = static_cast<Long>(M_PI), nu = p.poisson_ratio,
                 solid = 1 - static_cast<Long>(p.porosity);
      const Long q = 3 * pi * (1 - nu) * p.pressure / (2 * solid * p.coordination_number * p.shear_modulus);
      const Long d = bisected(b, q), S_n = 4 * std::sqrt(d * d + static_cast<Long>(b) * b) / (1 - nu);
      const Long S_t = 8 * b / (2 - nu), scale = 9 * solid * p.shear_modulus / pi;
      const auto m = digby(p);
      CAPTURE(pressure);
      CAPTURE(b);
      CHECK(m.bulk_modulus == relative(double(scale * S_n / 12), 8 * 1.2e-16));
      CHECK(m.shear_modulus == relative(double(scale * (S_n + 1.5L * S_t) / 20), 8 * 1.2e-16));
    }
  CHECK(tried >= 8 * 24);
}

TEST_CASE("digby: limits") {
  // Without bonds: the smooth packing, at any pressure.
  for (const double pressure : {0.0, 1e-300, 1e-150, 1.0, 1e12}) {
    const auto free =
        digby(with(with(bonded, &BondedPacking::bond_radius_ratio, 0), &BondedPacking::pressure, pressure));
    const auto smooth =
        rock_physics::hertz_mindlin({bonded.shear_modulus, bonded.poisson_ratio, bonded.porosity,
                                     bonded.coordination_number, pressure, 0});
    CHECK(std::abs(free.bulk_modulus - smooth.bulk_modulus) <= 9e-16 * smooth.bulk_modulus);
    CHECK(std::abs(free.shear_modulus - smooth.shear_modulus) <= 9e-16 * smooth.shear_modulus);
  }
  // Without pressure: the bonds alone, a = b to the last bit.
  const auto unloaded = digby(with(bonded, &BondedPacking::pressure, 0));
  const double rough = 3 * (1 - bonded.poisson_ratio) / (2 - bonded.poisson_ratio);
  CHECK(unloaded.shear_modulus == relative(0.6 * unloaded.bulk_modulus * (1 + rough), 4e-16));
  CHECK(unloaded.bulk_modulus ==
        relative(9 * 0.64 * 44e9 * 0.2 / (3 * M_PI * (1 - bonded.poisson_ratio)), 4e-16));
  CHECK(digby(with(bonded, &BondedPacking::pressure, 1e-300)).bulk_modulus == unloaded.bulk_modulus);
  const auto empty = digby(with(bonded, &BondedPacking::coordination_number, 0));
  CHECK(empty.bulk_modulus == 0);
  CHECK(empty.shear_modulus == 0);
}

TEST_CASE("digby: bad input and notes") {
  test::check_refused(bonded,
                      {&BondedPacking::shear_modulus, &BondedPacking::poisson_ratio, &BondedPacking::porosity,
                       &BondedPacking::coordination_number, &BondedPacking::pressure,
                       &BondedPacking::bond_radius_ratio},
                      digby);
  CHECK_THROWS_AS((void)digby(with(bonded, &BondedPacking::bond_radius_ratio, 1)), InvalidArgument);
  CHECK_FALSE(digby(bonded).validity.ok());
  CHECK(digby(with(bonded, &BondedPacking::bond_radius_ratio, 0.05)).validity.ok());
}
