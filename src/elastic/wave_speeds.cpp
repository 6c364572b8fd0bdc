// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/elastic/wave_speeds.hpp>

#include <cmath>

#include <granum/core/error.hpp>

namespace granum::elastic {

double bulk_density(const GrainsAndPores& packing) {
  const double grains = require_positive("grain_density", packing.grain_density, "kg/m3");
  const double e = require_non_negative("void_ratio", packing.void_ratio);
  const double pores = require_non_negative("pore_density", packing.pore_density, "kg/m3");
  return (grains + e * pores) / (1 + e);
}

WaveSpeeds wave_speeds(const Isotropic& solid, double bulk_density) {
  require_positive("bulk_density", bulk_density, "kg/m3");
  if (std::isinf(solid.bulk_modulus()))
    throw InvalidArgument("an incompressible solid (Poisson's ratio 0.5) has no finite P-wave speed");
  const double axial = solid.bulk_modulus() + 4 * solid.shear_modulus() / 3;
  return {.p = std::sqrt(axial / bulk_density), .s = std::sqrt(solid.shear_modulus() / bulk_density)};
}

double shear_modulus_from_speed(double shear_wave_speed, double bulk_density) {
  require_non_negative("shear_wave_speed", shear_wave_speed, "m/s");
  require_positive("bulk_density", bulk_density, "kg/m3");
  return bulk_density * (shear_wave_speed * shear_wave_speed);
}

Isotropic isotropic_from_speeds(const WaveSpeeds& speeds, double bulk_density) {
  const double V_s = require_positive("shear_wave_speed", speeds.s, "m/s");
  const double V_p = require_positive("compression_wave_speed", speeds.p, "m/s");
  const double shear_modulus = shear_modulus_from_speed(V_s, bulk_density);
  const double bulk_modulus = bulk_density * ((V_p - V_s) * (V_p + V_s) - V_s * V_s / 3);
  if (!(bulk_modulus > 0))
    throw InvalidArgument("compression_wave_speed", V_p, "m/s", "(sqrt(4/3) shear_wave_speed, inf)");
  return Isotropic::from_bulk_and_shear(bulk_modulus, shear_modulus);
}

} // namespace granum::elastic
