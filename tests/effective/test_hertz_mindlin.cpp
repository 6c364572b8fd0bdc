// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/hertz_mindlin.hpp>

#include <doctest/doctest.h>

#include <limits>

#include <granum/core/error.hpp>
#include <granum/effective/uniform_field.hpp>
#include <granum/elastic/isotropic.hpp>

#include "relative.hpp"

using namespace granum;
using namespace granum::effective;

namespace {

/// Quartz as the rock physics codes of the comparison take it: K = 36.6 GPa, G = 45 GPa.
SpherePack quartz() {
  const auto mineral = elastic::Isotropic::from_bulk_and_shear(36.6e9, 45e9);
  return {.grain = {45e9, mineral.poisson_ratio()},
          .porosity = 0.4,
          .coordination_number = 8.6,
          .pressure = 20e6};
}

} // namespace

TEST_CASE("hertz_mindlin: the numbers on which the public libraries agree") {
  const IsotropicModuli rough = hertz_mindlin(quartz()), smooth = hertz_mindlin(quartz(), 0);
  CHECK(rough.bulk_modulus == relative(1.906319860921191e9, 1e-14));
  CHECK(rough.shear_modulus == relative(2.802805417138183e9, 1e-14));
  CHECK(smooth.bulk_modulus == rough.bulk_modulus);
  CHECK(smooth.shear_modulus == relative(1.143791916552714e9, 1e-14));
  CHECK(hertz_mindlin(quartz(), 0.25).shear_modulus ==
        relative(0.25 * rough.shear_modulus + 0.75 * smooth.shear_modulus, 1e-14));
}

TEST_CASE("hertz_mindlin: the uniform strain of a state of spheres of any size") {
  for (const double nu : {-0.9, 0.0, 0.25, 0.5})
    for (const double radius : {1e-9, 5e-4, 1e3})
      for (const double p : {1e-3, 1e5, 1e9}) {
        const contact::GrainMaterial grain{30e9, nu};
        const SpherePack pack{.grain = grain, .porosity = 0.35, .coordination_number = 6.3, .pressure = p};
        const auto c = uniform_strain({.law = contact::PowerLaw::sphere(grain, radius),
                                       .tangential_ratio = contact::mindlin_stiffness_ratio(nu),
                                       .radius = radius,
                                       .void_ratio = 0.35 / 0.65,
                                       .coordination_number = 6.3,
                                       .stress_v = p,
                                       .stress_h = p})
                           .stiffness;
        CHECK(hertz_mindlin(pack).bulk_modulus == relative(c.bulk_modulus(), 1e-14));
        CHECK(hertz_mindlin(pack).shear_modulus == relative(c.G_hh(), 1e-14));
      }
}

TEST_CASE("hertz_mindlin: limits are exact, extremes stay finite") {
  SpherePack pack = quartz();
  pack.pressure = 0;
  CHECK(hertz_mindlin(pack).bulk_modulus == 0);
  CHECK(hertz_mindlin(pack).shear_modulus == 0);
  pack = quartz();
  pack.coordination_number = 0;
  CHECK(hertz_mindlin(pack).shear_modulus == 0);
  // K^3 ~ p and K^3 ~ m^2, over the ranges where the product of both is no double.
  pack = quartz();
  const double K = hertz_mindlin(pack).bulk_modulus;
  for (const double factor : {1e-300, 1e-60, 1e60, 1e300}) {
    SpherePack far = pack;
    far.pressure *= factor;
    CHECK(hertz_mindlin(far).bulk_modulus == relative(K * std::cbrt(factor), 4e-15));
  }
  pack.grain.shear_modulus = 45e189;
  CHECK(hertz_mindlin(pack).bulk_modulus == relative(K * 1e120, 4e-15));
}

TEST_CASE("hertz_mindlin: what no packing can have is refused by name") {
  const auto refused = [](auto change, const char* text) {
    SpherePack pack = quartz();
    change(pack);
    CHECK_THROWS_WITH_AS((void)hertz_mindlin(pack), text, InvalidArgument);
  };
  refused([](SpherePack& p) { p.porosity = 40; }, "porosity = 40 is outside (0, 1)");
  refused([](SpherePack& p) { p.coordination_number = -8.6; },
          "coordination_number = -8.6 is outside [0, inf)");
  refused([](SpherePack& p) { p.pressure = -1; }, "pressure = -1 Pa is outside [0, inf)");
  refused([](SpherePack& p) { p.grain.poisson_ratio = 0.6; },
          "grain_poisson_ratio = 0.6 is outside (-1, 0.5]");
  refused([](SpherePack& p) { p.grain.shear_modulus = 0; }, "grain_shear_modulus = 0 Pa is outside (0, inf)");
  refused([](SpherePack& p) { p.porosity = std::numeric_limits<double>::quiet_NaN(); },
          "porosity = nan is outside (0, 1)");
  CHECK_THROWS_WITH_AS((void)hertz_mindlin(quartz(), 5), "no_slip_share = 5 is outside [0, 1]",
                       InvalidArgument);
}
