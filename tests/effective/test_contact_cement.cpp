// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/contact_cement.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <granum/core/error.hpp>
#include <granum/elastic/isotropic.hpp>

#include "relative.hpp"

using namespace granum;
using namespace granum::effective;

namespace {

contact::GrainMaterial solid(double K, double G) {
  return {G, elastic::Isotropic::from_bulk_and_shear(K, G).poisson_ratio()};
}

/// Quartz sand with quartz cement, porosity 0.36 of 0.4.
CementedPack pack_of(CementPlace place) {
  return {.grain = solid(36.6e9, 45e9),
          .cement = solid(37e9, 45e9),
          .critical_porosity = 0.4,
          .porosity = 0.36,
          .coordination_number = 8.6,
          .place = place};
}

} // namespace

TEST_CASE("contact cement: the volume of the cement is what the pores have lost") {
  // In a layer of thickness t on spheres of radius R the cement takes 4 pi R^2 t, to first order in t; by the
  // definition of the second scheme its contact radius is that of two layers that touch: a^2 = 2 R t.
  const CementedPack p = pack_of(CementPlace::on_surfaces);
  const double a = cement_radius_ratio(p), t = a * a / 2;
  CHECK(4 * M_PI * t / (4 * M_PI / 3) * (1 - 0.4) == relative(0.04, 1e-14));
  // At the contacts: a lens of radius a between two spheres, gap r^2/R, holds pi a^4/(2 R); a grain has half
  // of C_n of them.
  const double b = cement_radius_ratio(pack_of(CementPlace::at_contacts));
  CHECK(8.6 / 2 * (M_PI * std::pow(b, 4) / 2) / (4 * M_PI / 3) * (1 - 0.4) == relative(0.04, 1e-14));
}

TEST_CASE("contact cement: the regressions of the source") {
  for (const CementPlace place : {CementPlace::at_contacts, CementPlace::on_surfaces}) {
    const CementedPack p = pack_of(place);
    const double nu = p.grain.poisson_ratio, nu_c = p.cement.poisson_ratio, a = cement_radius_ratio(p);
    const double L_n = 2 * 45e9 * (1 - nu) * (1 - nu_c) / (M_PI * 45e9 * (1 - 2 * nu_c)), L_t = 1 / M_PI;
    const double S_n = -0.024153 * std::pow(L_n, -1.3646) * a * a + 0.20405 * std::pow(L_n, -0.89008) * a +
                       0.00024649 * std::pow(L_n, -1.9864);
    const double A =
        -1e-2 * (2.26 * nu * nu + 2.07 * nu + 2.3) * std::pow(L_t, 0.079 * nu * nu + 0.1754 * nu - 1.342);
    const double B =
        (0.0573 * nu * nu + 0.0937 * nu + 0.202) * std::pow(L_t, 0.0274 * nu * nu + 0.0529 * nu - 0.8765);
    const double C =
        1e-4 * (9.654 * nu * nu + 4.945 * nu + 3.1) * std::pow(L_t, 0.01867 * nu * nu + 0.4011 * nu - 1.8186);
    const double K = 8.6 * 0.6 * (37e9 + 4.0 / 3 * 45e9) * S_n / 6;
    const double G = 0.6 * K + 0.15 * 8.6 * 0.6 * 45e9 * (A * a * a + B * a + C);
    const CementedModuli m = contact_cement(p);
    CHECK(m.moduli.bulk_modulus == relative(K, 1e-14));
    CHECK(m.moduli.shear_modulus == relative(G, 1e-14));
    CHECK(m.validity.ok());
  }
  const double at_contacts = contact_cement(pack_of(CementPlace::at_contacts)).moduli.bulk_modulus;
  CHECK(at_contacts > contact_cement(pack_of(CementPlace::on_surfaces)).moduli.bulk_modulus);
}

TEST_CASE("contact cement: what the regression was not made for is said") {
  CementedPack soft = pack_of(CementPlace::at_contacts);
  soft.cement = {1e3, 0.3};
  const CementedModuli m = contact_cement(soft);
  REQUIRE_FALSE(m.validity.ok());
  CHECK(m.validity.notes.front().find("regression") != std::string::npos);
  CementedPack full = pack_of(CementPlace::on_surfaces);
  full.critical_porosity = 0.7;
  full.porosity = 0;
  CHECK(contact_cement(full).validity.notes.front().find("radius of the grains") != std::string::npos);
}

TEST_CASE("contact cement: what no packing can have is refused by name") {
  CementedPack p = pack_of(CementPlace::at_contacts);
  p.cement.poisson_ratio = 0.5;
  CHECK_THROWS_WITH_AS((void)contact_cement(p), "cement_poisson_ratio = 0.5 is outside (-1, 0.5)",
                       InvalidArgument);
  p = pack_of(CementPlace::at_contacts);
  p.porosity = 0.41;
  CHECK_THROWS_WITH_AS((void)contact_cement(p), "porosity = 0.41 is outside [0, 0.4]", InvalidArgument);
  p = pack_of(CementPlace::at_contacts);
  p.cement.shear_modulus = 0;
  CHECK_THROWS_AS((void)contact_cement(p), InvalidArgument);
}
