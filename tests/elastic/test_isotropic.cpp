// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/elastic/isotropic.hpp>

#include "samples.hpp"
#include "unit.hpp"

using namespace granum::elastic;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
using test::rounding;

} // namespace

TEST_CASE("every pair of constants gives the same solid back") {
  for (const double nu : {-0.9, -0.3, 0.0, 0.15, 0.3, 0.45, 0.499}) {
    const Isotropic solid = Isotropic::from_young_and_poisson(70e9, nu);
    const double k = solid.bulk_modulus(), g = solid.shear_modulus();
    // near 0.5 the bulk modulus magnifies the rounding of nu by 1/(1-2 nu)
    const double tolerance = rounding / (1 - 2 * nu);
    CHECK(solid.young_modulus() == relative(70e9, rounding));
    CHECK(std::abs(solid.poisson_ratio() - nu) < rounding);
    CHECK(Isotropic::from_shear_and_poisson(g, nu).bulk_modulus() == relative(k, tolerance));
    CHECK(Isotropic::from_lame(solid.lame_lambda(), g).bulk_modulus() == relative(k, tolerance));
    CHECK(Isotropic::from_bulk_and_shear(k, g).young_modulus() == relative(70e9, rounding));
  }
}

TEST_CASE("the limits of Poisson's ratio stay numbers") {
  const Isotropic rubber = Isotropic::from_shear_and_poisson(1e6, 0.5);
  CHECK(rubber.bulk_modulus() == inf);
  CHECK(rubber.poisson_ratio() == 0.5);
  CHECK(rubber.young_modulus() == 3e6);
  CHECK(rubber.lame_lambda() == inf);
  CHECK_THROWS_AS((void)voigt(rubber), InvalidArgument);
  const double nearly = std::nextafter(-1.0, 0.0);
  const Isotropic auxetic = Isotropic::from_shear_and_poisson(1e6, nearly);
  CHECK(auxetic.bulk_modulus() > 0);
  CHECK(auxetic.poisson_ratio() == relative(-1, rounding));
  CHECK(Isotropic::from_bulk_and_shear(std::numeric_limits<double>::denorm_min(), 1e6).poisson_ratio() >= -1);
}

TEST_CASE("impossible constants are refused") {
  for (const auto& [young, nu] : {std::pair(1e9, 0.6), {1e9, -1.0}, {0.0, 0.2}})
    CHECK_THROWS_AS((void)Isotropic::from_young_and_poisson(young, nu), InvalidArgument);
  for (const auto& [bulk, shear] : {std::pair(0.0, 1e9), {1e9, inf}, {std::nan(""), 1e9}})
    CHECK_THROWS_AS((void)Isotropic::from_bulk_and_shear(bulk, shear), InvalidArgument);
  CHECK_THROWS_AS((void)Isotropic::from_lame(-0.7e9, 1e9), InvalidArgument);
}
