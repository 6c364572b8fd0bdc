// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/digby.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <granum/core/error.hpp>
#include <granum/elastic/isotropic.hpp>

#include "relative.hpp"

using namespace granum;
using namespace granum::effective;

namespace {

SpherePack pack_at(double pressure, double C = 9) {
  return {.grain = {44e9, elastic::Isotropic::from_bulk_and_shear(37e9, 44e9).poisson_ratio()},
          .porosity = 0.36,
          .coordination_number = C,
          .pressure = pressure};
}

/// Moduli with the root of Digby's cubic by bisection in long double.
IsotropicModuli by_bisection(const SpherePack& p, double b) {
  const long double nu = p.grain.poisson_ratio, mu = p.grain.shear_modulus, C = p.coordination_number;
  const long double phi = 1 - static_cast<long double>(p.porosity), pi = 3.14159265358979323846L;
  const long double load = 3 * pi * (1 - nu) * p.pressure / (2 * C * phi * mu);
  const auto excess = [&](long double d) { return d * d * d + 1.5L * b * b * d - load; };
  long double low = 0, high = 1;
  while (excess(high) < 0)
    high *= 2;
  for (int k = 0; k < 4000 && high > low; ++k) {
    const long double middle = (low + high) / 2;
    if (middle == low || middle == high)
      break;
    (excess(middle) < 0 ? low : high) = middle;
  }
  const long double a = std::sqrt(low * low + static_cast<long double>(b) * b);
  const long double S_n = 4 * mu * a / (1 - nu), S_t = 8 * mu * b / (2 - nu);
  return {static_cast<double>(C * phi * S_n / (12 * pi)),
          static_cast<double>(C * phi * (S_n + 1.5L * S_t) / (20 * pi))};
}

} // namespace

TEST_CASE("digby: the numbers of the public libraries") {
  const IsotropicModuli m = digby(pack_at(20e6), 0.2);
  CHECK(m.bulk_modulus == relative(5.81155426e9, 2e-9));
  CHECK(m.shear_modulus == relative(8.51375906e9, 2e-9));
}

TEST_CASE("digby: the root of the cubic by bisection, for any load and bond") {
  for (const double p : {1e-300, 1e-30, 1.0, 1e5, 1e9, 1e12})
    for (const double b : {1e-12, 1e-6, 1e-3, 0.05, 0.3, 1.0}) {
      const IsotropicModuli closed = digby(pack_at(p), b), search = by_bisection(pack_at(p), b);
      CHECK(closed.bulk_modulus == relative(search.bulk_modulus, 2e-15));
      CHECK(closed.shear_modulus == relative(search.shear_modulus, 2e-15));
    }
}

TEST_CASE("digby: without bonds smooth spheres, without pressure the bonds alone") {
  const IsotropicModuli unbonded = digby(pack_at(20e6), 0), smooth = hertz_mindlin(pack_at(20e6), 0);
  CHECK(unbonded.bulk_modulus == relative(smooth.bulk_modulus, 2e-15));
  CHECK(unbonded.shear_modulus == relative(smooth.shear_modulus, 2e-15));
  const SpherePack p = pack_at(0);
  const double nu = p.grain.poisson_ratio, S_n = 4 * 44e9 * 0.2 / (1 - nu), S_t = 8 * 44e9 * 0.2 / (2 - nu);
  CHECK(digby(p, 0.2).bulk_modulus == relative(9 * 0.64 * S_n / (12 * M_PI), 2e-15));
  CHECK(digby(p, 0.2).shear_modulus == relative(9 * 0.64 * (S_n + 1.5 * S_t) / (20 * M_PI), 2e-15));
  CHECK(digby(p, 0).bulk_modulus == 0);
  CHECK(digby(p, 0).shear_modulus == 0);
  CHECK(digby(pack_at(20e6, 0), 0.2).bulk_modulus == 0);
}

TEST_CASE("digby: what no packing can have is refused by name") {
  CHECK_THROWS_WITH_AS((void)digby(pack_at(-1), 0.2), "pressure = -1 Pa is outside [0, inf)",
                       InvalidArgument);
  CHECK_THROWS_WITH_AS((void)digby(pack_at(1), -0.2), "bond_radius_ratio = -0.2 is outside [0, inf)",
                       InvalidArgument);
}
