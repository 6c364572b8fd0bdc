// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/rock_physics/sphere_packs.hpp>

#include <granum/effective/uniform_field.hpp>

#include "states.hpp"
#include "thresholds.hpp"
#include "unit.hpp"

using rock_physics::hertz_mindlin;
using rock_physics::SpherePacking;
using test::with;

namespace {

/// The example that public rock-physics libraries share: bulk modulus 36.6 and shear modulus 45 GPa.
constexpr SpherePacking golden{.shear_modulus = 45e9,
                               .poisson_ratio = (3 * 36.6 - 2 * 45) / (2 * (3 * 36.6 + 45)),
                               .porosity = 0.4,
                               .coordination_number = 8.6,
                               .pressure = 20e6};

} // namespace

TEST_CASE("hertz mindlin: the golden example of the public libraries") {
  const auto rough = hertz_mindlin(golden);
  const auto smooth = hertz_mindlin(with(golden, &SpherePacking::no_slip_fraction, 0));
  // Printed with 16 digits; their own rounding and that of Poisson's ratio leave some 1e-15.
  CHECK(rough.bulk_modulus == relative(1.906319860921191e9, 1e-14));
  CHECK(rough.shear_modulus == relative(2.802805417138183e9, 1e-14));
  CHECK(smooth.bulk_modulus == rough.bulk_modulus);
  CHECK(smooth.shear_modulus == relative(1.143791916552714e9, 1e-14));
  CHECK(rough.validity.ok());
}

TEST_CASE("hertz mindlin: equals uniform strain of sphere contacts at the same state") {
  for (const double nu : {-0.9, 0.0, 0.25, 0.5})
    for (const double slip : {0.0, 0.3, 1.0})
      for (const double pressure : {1.0, 1e5, 1e8}) {
        const SpherePacking packing{30e9, nu, 0.38, 6.5, pressure, slip};
        const effective::State state{.law = contact::PowerLaw::sphere({30e9, nu}, 3e-4),
                                     .tangential_ratio = slip * contact::mindlin_stiffness_ratio(nu),
                                     .radius = 3e-4,
                                     .void_ratio = 0.38 / 0.62,
                                     .coordination_number = 6.5,
                                     .stress_v = pressure,
                                     .stress_h = pressure};
        const auto closed = hertz_mindlin(packing);
        const auto contacts = effective::uniform_strain(state).stiffness;
        CAPTURE(nu);
        CHECK(closed.bulk_modulus == relative(contacts.bulk_modulus(), 1e-14));
        CHECK(closed.shear_modulus == relative(contacts.C44, 1e-14));
      }
}

TEST_CASE("hertz mindlin: limits are exact") {
  for (const auto member : {&SpherePacking::pressure, &SpherePacking::coordination_number}) {
    const auto empty = hertz_mindlin(with(golden, member, 0));
    CHECK(empty.bulk_modulus == 0);
    CHECK(empty.shear_modulus == 0);
  }
  CHECK(hertz_mindlin(with(golden, &SpherePacking::pressure, 0)).validity.ok());
  CHECK_FALSE(hertz_mindlin(with(golden, &SpherePacking::coordination_number, 0)).validity.ok());
  // Digby's ratio K/G = 5 (2-nu)/(3 (5-4 nu)) at the ends of the domain.
  for (const double nu : {-0.999, 0.0, 0.25, 0.5}) {
    const auto m = hertz_mindlin(with(golden, &SpherePacking::poisson_ratio, nu));
    CHECK(m.bulk_modulus / m.shear_modulus == relative(5 * (2 - nu) / (3 * (5 - 4 * nu)), 2e-15));
  }
}

TEST_CASE("hertz mindlin: pressures from 1e-300 to 1e12 Pa keep every digit") {
  // Pressures that differ by 8^k differ in K by exactly 2^k, whichever way the root is taken.
  const double base = hertz_mindlin(golden).bulk_modulus;
  int tried = 0;
  for (int k = -334; k <= 5; ++k, ++tried) {
    const auto m = hertz_mindlin(with(golden, &SpherePacking::pressure, std::ldexp(20e6, 3 * k)));
    CHECK(m.bulk_modulus == relative(std::ldexp(base, k), 9e-16));
  }
  CHECK(tried == 340);
  // Soft and hard grains whose squared modulus no double holds.
  for (const int k : {-250, 250}) {
    const SpherePacking scaled{std::ldexp(45e9, 3 * k), golden.poisson_ratio, 0.4, 8.6,
                               std::ldexp(20e6, 3 * k)};
    CHECK(hertz_mindlin(scaled).bulk_modulus == relative(std::ldexp(base, 3 * k), 2e-15));
  }
}

TEST_CASE("hertz mindlin: values outside the theory are noted, impossible ones refused") {
  const auto threshold = [](double at, double SpherePacking::*member) {
    check_threshold(at,
                    [&](double x) { return hertz_mindlin(with(golden, member, x)).validity.notes.size(); });
  };
  threshold(12, &SpherePacking::coordination_number);
  // contacts of a tenth of the radius
  threshold(2e-3 * 45e9 * 8.6 * 0.6 / (3 * std::numbers::pi * (1 - golden.poisson_ratio)),
            &SpherePacking::pressure);
  // Moduli in GPa with a pressure in MPa.
  CHECK_FALSE(hertz_mindlin(with(golden, &SpherePacking::shear_modulus, 45)).validity.ok());
  test::check_refused(golden,
                      {&SpherePacking::shear_modulus, &SpherePacking::poisson_ratio, &SpherePacking::porosity,
                       &SpherePacking::coordination_number, &SpherePacking::pressure,
                       &SpherePacking::no_slip_fraction},
                      hertz_mindlin);
  for (const auto& [member, value] : {std::pair(&SpherePacking::shear_modulus, 0.0),
                                      {&SpherePacking::poisson_ratio, 0.51},
                                      {&SpherePacking::porosity, 1.0},
                                      {&SpherePacking::no_slip_fraction, 5.0}})
    CHECK_THROWS_AS((void)hertz_mindlin(with(golden, member, value)), InvalidArgument);
}
