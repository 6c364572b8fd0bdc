// SPDX-License-Identifier: GPL-3.0-or-later
// Notation: nu of the grain, nu_c and G_c of the cement, a radius of the cement over that of the grain.
#include <granum/effective/contact_cement.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sphere_pack.hpp"

namespace granum::effective {

namespace {

void require_valid(const CementedPack& p) {
  require_grain(p.grain);
  require_positive("cement_shear_modulus", p.cement.shear_modulus, "Pa");
  require_open("cement_poisson_ratio", p.cement.poisson_ratio, -1, 0.5);
  require_open("critical_porosity", p.critical_porosity, 0, 1);
  require_closed("porosity", p.porosity, 0, p.critical_porosity);
  require_positive("coordination_number", p.coordination_number);
}

/// c2 a^2 + c1 a + c0.
struct Quadratic {
  double c2, c1, c0;
  [[nodiscard]] double operator()(double a) const { return (c2 * a + c1) * a + c0; }
};

Quadratic normal_regression(const CementedPack& p) {
  const double nu = p.grain.poisson_ratio, nu_c = p.cement.poisson_ratio;
  const double L = 2 / std::numbers::pi * (p.cement.shear_modulus / p.grain.shear_modulus) *
                   ((1 - nu) * (1 - nu_c) / (1 - 2 * nu_c));
  return {-0.024153 * std::pow(L, -1.3646), 0.20405 * std::pow(L, -0.89008),
          0.00024649 * std::pow(L, -1.9864)};
}

Quadratic tangential_regression(const CementedPack& p) {
  const double nu = p.grain.poisson_ratio;
  const double L = p.cement.shear_modulus / p.grain.shear_modulus / std::numbers::pi;
  const auto in_nu = [nu](double c2, double c1, double c0) { return (c2 * nu + c1) * nu + c0; };
  return {-1e-2 * in_nu(2.26, 2.07, 2.3) * std::pow(L, in_nu(0.079, 0.1754, -1.342)),
          in_nu(0.0573, 0.0937, 0.202) * std::pow(L, in_nu(0.0274, 0.0529, -0.8765)),
          1e-4 * in_nu(9.654, 4.945, 3.1) * std::pow(L, in_nu(0.01867, 0.4011, -1.8186))};
}

double bulk_modulus(const contact::GrainMaterial& solid) {
  return 2 * solid.shear_modulus * (1 + solid.poisson_ratio) / (3 * (1 - 2 * solid.poisson_ratio));
}

void note_limits(const CementedPack& p, double radius, CementedModuli& out) {
  if (radius > 1)
    out.validity.add("the cement reaches beyond the radius of the grains: contacts are no longer apart");
  const double stiffest_G = std::max(p.grain.shear_modulus, p.cement.shear_modulus);
  const double stiffest_K = std::max(bulk_modulus(p.grain), bulk_modulus(p.cement));
  if (out.moduli.shear_modulus > stiffest_G || out.moduli.bulk_modulus > stiffest_K)
    out.validity.add(
        "stiffer than grains and cement themselves: the regression does not hold for this cement");
}

} // namespace

double cement_radius_ratio(const CementedPack& p) {
  require_valid(p);
  const double filled = (p.critical_porosity - p.porosity) / (3 * (1 - p.critical_porosity));
  return p.place == CementPlace::at_contacts ? 2 * std::sqrt(std::sqrt(filled / p.coordination_number))
                                             : std::sqrt(2 * filled);
}

CementedModuli contact_cement(const CementedPack& p) {
  const double radius = cement_radius_ratio(p);
  const double contacts = p.coordination_number * (1 - p.critical_porosity);
  const double G_c = p.cement.shear_modulus;
  const double M_c = bulk_modulus(p.cement) + 4 * G_c / 3;
  const double K = contacts * M_c * normal_regression(p)(radius) / 6;
  CementedModuli out{
      .moduli = {.bulk_modulus = K,
                 .shear_modulus = 0.6 * K + 0.15 * contacts * G_c * tangential_regression(p)(radius)},
      .validity = {}};
  note_limits(p, radius, out);
  return out;
}

} // namespace granum::effective
