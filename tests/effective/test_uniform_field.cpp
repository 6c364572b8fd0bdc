// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/uniform_field.hpp>

#include "support.hpp"
#include "unit.hpp"

using namespace granum::test;
using effective::UniformContacts;

TEST_CASE("uniform field: closed forms in the fabric") {
  // The published polynomials in a, written out once more; moduli are engineering constants of the two
  // stiffnesses.
  const double P = 2.5, k_n = 3;
  for (double a = -1; a <= 1; a += 0.125)
    for (const double r : {0.3, 0.919, 1.2}) {
      CAPTURE(a);
      CAPTURE(r);
      const double k_t = r * k_n;
      const UniformContacts c{
          .prefactor = P, .normal_stiffness = k_n, .tangential_stiffness = k_t, .fabric_anisotropy = a};
      const auto V = effective::uniform_strain_stiffness(c); // its constants: test_directional.cpp
      CHECK(close(V.E_v(),
                  P * k_n * (70 - 20 * a - 26 * a * a + r * (105 - 50 * a + 5 * a * a)) /
                      (5 * (3 - a) * (28 - 20 * a + r * (7 - a))),
                  1e-14));

      const auto R = effective::uniform_stress_stiffness(c);
      const double h = 5 - 3 * a, v = 5 + a, q = 5 * (3 - a) / (7 * P * k_n * k_t);
      const double E_v = v * v / (q * (14 * k_n + 21 * k_t - 2 * a * k_n + 9 * a * k_t));
      const double E_h = h * h / (q * (14 * k_n + 21 * k_t - 6 * a * k_n - 15 * a * k_t));
      const double nu_vh =
          (7 - a) * v * (k_n - k_t) / (h * (14 * k_n + 21 * k_t - 2 * a * k_n + 9 * a * k_t));
      CHECK(close(R.E_v(), E_v, 1e-14));
      CHECK(close(R.E_h(), E_h, 1e-14));
      CHECK(std::abs(R.C13 / (R.C11 + R.C12) - nu_vh) < 1e-14);
      CHECK(close(R.G_hh(),
                  7 * P * k_n * k_t * h * h /
                      (10 * (3 - a) * (21 * k_n + 14 * k_t - 11 * a * k_n - 10 * a * k_t)),
                  1e-14));
      CHECK(close(
          R.G_vh(),
          7 * P * k_n * k_t * v * v * h * h /
              (10 * (5 - a) * (3 - a) *
               (105 * k_n + 70 * k_t - 46 * a * k_n - 24 * a * k_t - 23 * a * a * k_n + 2 * a * a * k_t)),
          1e-14));
    }
}

TEST_CASE("uniform field: contacts of the mean force") {
  // The same as the direction-dependent estimate where forces do not depend on direction or the law is
  // linear; fabric alone spreads the forces of a curved contact.
  for (const double alpha : {1.0, 1.5, 2.0, infinity})
    for (const State& s : {state_of(alpha, 0, 0.2, 1e5, 1e5), state_of(alpha, 0.7, 0.2, 3e5, 1e5)}) {
      if (s.fabric_anisotropy != 0 && alpha < 2)
        continue;
      const UniformContacts c = effective::uniform_contacts(s);
      const double strain = difference(effective::uniform_strain_stiffness(c),
                                       effective::uniform_strain(s).stiffness),
                   stress = difference(effective::uniform_stress_stiffness(c),
                                       effective::uniform_stress(s).stiffness);
      if (alpha == 2 && s.fabric_anisotropy != 0)
        CHECK(strain > 1e-2);
      else
        CHECK(std::max(strain, stress) < 1e-14);
    }
}

TEST_CASE("uniform field: limits of the contact stiffness") {
  const UniformContacts none{.prefactor = 1, .normal_stiffness = 0, .tangential_stiffness = 0};
  CHECK(effective::uniform_stress_stiffness(none) == elastic::TransverselyIsotropic{});
  for (const double a : {-1.0, 0.0, 1.0}) {
    // Without tangential stiffness only stresses along F are carried: one mode, no shear.
    const auto smooth = effective::uniform_stress_stiffness(
        {.prefactor = 9, .normal_stiffness = 1, .tangential_stiffness = 0, .fabric_anisotropy = a});
    CHECK(smooth.C44 == 0);
    CHECK(smooth.C66() == 0);
    CHECK(close(smooth.C13 * smooth.C13, smooth.C11 * smooth.C33, 1e-14));
    CHECK(close(smooth.bulk_modulus(), 1, 1e-14)); // P k_n/9 (2 F11 + F33)^2
  }
}

TEST_CASE("uniform field: the two isotropic moduli alone") {
  for (const double alpha : {1.0, 1.5, 2.0, infinity})
    for (const double pressure : {0.0, 1e-300, 1e5, 1e12})
      for (const double coordination : {1e-3, 5.0, 14.0}) {
        State s = state_of(alpha, 0, 0.15, pressure, pressure);
        s.coordination_number = coordination;
        if (coordination == 5) // of unequal grains
          s.contacts = {.branch = 1.02, .branch_square = 1.08, .pair_radius = 0.98, .grain_volume = 1.1};
        const effective::IsotropicPacking packing{.law = s.law,
                                                  .tangential_ratio = s.tangential_ratio,
                                                  .radius = s.radius,
                                                  .void_ratio = s.void_ratio,
                                                  .coordination_number = coordination,
                                                  .pressure = pressure,
                                                  .contacts = s.contacts};
        const auto moduli = effective::uniform_strain_moduli(packing);
        const auto stiffness = effective::uniform_strain(s).stiffness;
        CHECK(close(moduli.bulk_modulus, stiffness.bulk_modulus(), 4e-15)); // K: a sum of four of them
        CHECK(close(moduli.shear_modulus, stiffness.G_vh(), 4e-15));
        auto rough = packing;
        rough.tangential_ratio = 1e20;
        CHECK(effective::uniform_strain_moduli(rough).bulk_modulus == moduli.bulk_modulus);
        rough.pressure = -1;
        CHECK_THROWS_AS((void)effective::uniform_strain_moduli(rough), InvalidArgument);
      }
}

TEST_CASE("uniform field: bad input") {
  const UniformContacts good{.prefactor = 1, .normal_stiffness = 1, .tangential_stiffness = 1};
  const auto refused = [&](auto change) {
    UniformContacts c = good;
    change(c);
    CHECK_THROWS_AS((void)effective::uniform_strain_stiffness(c), InvalidArgument);
    CHECK_THROWS_AS((void)effective::uniform_stress_stiffness(c), InvalidArgument);
  };
  for (const double bad : {-1.0, infinity, State::unset}) {
    refused([&](UniformContacts& c) { c.prefactor = bad; });
    refused([&](UniformContacts& c) { c.normal_stiffness = bad; });
    refused([&](UniformContacts& c) { c.tangential_stiffness = bad; });
  }
  refused([](UniformContacts& c) { c.prefactor = 0; });
  refused([](UniformContacts& c) { c.normal_stiffness = 0; });
  refused([](UniformContacts& c) { c.tangential_stiffness = 1e20; });
  refused([](UniformContacts& c) { c.fabric_anisotropy = -2.5; });
}
