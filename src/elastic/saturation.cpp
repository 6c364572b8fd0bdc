// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/elastic/saturation.hpp>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>

namespace granum::elastic {

namespace {

constexpr double water = 2.18e9, air = 0.142e6; // [Pa]

} // namespace

double water_and_air_bulk_modulus(double saturation) {
  require_closed("saturation", saturation, 0, 1);
  return 1 / (saturation / water + (1 - saturation) / air);
}

double saturation_of_bulk_density(double bulk_density, double grain_density, double void_ratio) {
  const double rho = require_positive("bulk_density", bulk_density, "kg/m3");
  const double rho_s = require_positive("grain_density", grain_density, "kg/m3");
  const double e = require_positive("void_ratio", void_ratio);
  return ((1 + e) * rho - rho_s) / (e * water_density);
}

TransverselyIsotropic saturated(const TransverselyIsotropic& c, const SaturatedPores& pores) {
  const double K_s = require_positive("grain_bulk_modulus", pores.grain_bulk_modulus, "Pa");
  const double K_f = require_positive("fluid_bulk_modulus", pores.fluid_bulk_modulus, "Pa");
  const double n = require_positive("void_ratio", pores.void_ratio) / (1 + pores.void_ratio);
  if (!(c.bulk_modulus() <= K_s))
    throw InvalidArgument("grain_bulk_modulus", K_s, "Pa",
                          "[" + short_text(c.bulk_modulus()) +
                              ", inf): no skeleton is stiffer than its grains");
  const double a_h = 1 - (c.C11 + c.C12 + c.C13) / (3 * K_s);
  const double a_v = 1 - (2 * c.C13 + c.C33) / (3 * K_s);
  const double M = 1 / ((1 - c.bulk_modulus() / K_s - n) / K_s + n / K_f);
  return {.C11 = c.C11 + a_h * a_h * M,
          .C33 = c.C33 + a_v * a_v * M,
          .C12 = c.C12 + a_h * a_h * M,
          .C13 = c.C13 + a_h * a_v * M,
          .C44 = c.C44};
}

} // namespace granum::elastic
