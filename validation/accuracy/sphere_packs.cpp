// SPDX-License-Identifier: GPL-3.0-or-later
// Models of rock physics as their sources print them.
#include <granum/rock_physics/cement.hpp>
#include <granum/rock_physics/sphere_packs.hpp>

#include "harness.hpp"

namespace accuracy {

namespace {

using granum::rock_physics::SpherePacking;

SpherePacking draw_pack(Draw& draw) {
  return {.shear_modulus = draw.log_uniform(1e6, 1e12),
          .poisson_ratio = draw.poisson_ratio(),
          .porosity = draw.uniform(0.05, 0.95),
          .coordination_number = draw.coordination_number(),
          .pressure = draw.pressure()};
}

std::string said_of(const SpherePacking& p) {
  return said({{"G", p.shear_modulus},
               {"nu", p.poisson_ratio},
               {"porosity", p.porosity},
               {"C_n", p.coordination_number},
               {"p", p.pressure}});
}

/// [C^2 phi^2 G^2 p/(18 pi^2 (1-nu)^2)]^(1/3), phi the share of the spheres.
Real hertz_bulk_modulus(const SpherePacking& p) {
  const Real m = Real(p.coordination_number) * (1 - Real(p.porosity)) * Real(p.shear_modulus) /
                 (1 - Real(p.poisson_ratio));
  return cbrt(m * m * p.pressure / (18 * pi() * pi()));
}

void check_hertz_mindlin(Table& table, SpherePacking p, double share) {
  p.no_slip_fraction = share;
  const Real K = hertz_bulk_modulus(p), nu = p.poisson_ratio;
  const auto m = granum::rock_physics::hertz_mindlin(p);
  const std::string at = said_of(p) + " " + said({{"share", share}});
  const std::string domain = "p 1e-300 to 1e12 Pa, C_n to 14";
  table.take("hertz_mindlin", domain, closed_form, m.bulk_modulus, K, at);
  table.take("hertz_mindlin", domain, closed_form, m.shear_modulus,
             K * 3 * (2 + 3 * Real(share) * 2 * (1 - nu) / (2 - nu)) / 10, at);
}

/// The real root of the cubic by Newton's method from above, where it is convex.
Real cubic_root(const Real& q, const Real& t) {
  Real d = cbrt(2 * t) + sqrt(q);
  for (int k = 0; k < 200; ++k) {
    const Real next = d - (d * d * d + 3 * q * d - 2 * t) / (3 * d * d + 3 * q);
    if (!(next < d))
      break;
    d = next;
  }
  return d;
}

void check_digby(Table& table, const SpherePacking& p, double b) {
  const Real nu = p.poisson_ratio, mu = p.shear_modulus;
  const Real C = Real(p.coordination_number) * (1 - Real(p.porosity));
  const Real d = cubic_root(Real(b) * b / 2, 3 * pi() * (1 - nu) * p.pressure / (4 * C * mu));
  const Real S_n = 4 * mu * sqrt(d * d + Real(b) * b) / (1 - nu), S_t = 8 * mu * b / (2 - nu);
  const auto m = granum::rock_physics::digby({.shear_modulus = p.shear_modulus,
                                              .poisson_ratio = p.poisson_ratio,
                                              .porosity = p.porosity,
                                              .coordination_number = p.coordination_number,
                                              .pressure = p.pressure,
                                              .bond_radius_ratio = b});
  const std::string at = said_of(p) + " " + said({{"b/R", b}});
  const std::string domain = "b/R 1e-9 to 1, p 1e-300 to 1e12 Pa";
  const Reach reach = closed_form;
  table.take("digby", domain, reach, m.bulk_modulus, C * S_n / (12 * pi()), at);
  table.take("digby", domain, reach, m.shear_modulus, C * (S_n + 3 * S_t / 2) / (20 * pi()), at);
}

/// 1/(s/(a+c) + (1-s)/(b+c)) - c.
Real bound(const Real& a, const Real& b, const Real& s, const Real& c) {
  return 1 / (s / (a + c) + (1 - s) / (b + c)) - c;
}
Real zeta(const Real& K, const Real& G) { return G / 6 * (9 * K + 8 * G) / (K + 2 * G); }

void check_sand(Table& table, const SpherePacking& p, double porosity) {
  if (p.poisson_ratio == 0.5)
    return;
  const Real nu = p.poisson_ratio, G_s = p.shear_modulus;
  const Real K_s = 2 * G_s * (1 + nu) / (3 * (1 - 2 * nu));
  const Real K = hertz_bulk_modulus(p), G = K * 3 * (2 + 6 * (1 - nu) / (2 - nu)) / 10;
  const Real s = Real(porosity) / p.porosity;
  const auto soft = soft_sand(p, porosity), stiff = stiff_sand(p, porosity);
  const std::string at = said_of(p) + " " + said({{"sand", porosity}});
  const std::string domain = "porosity 0.01 to 0.99 of critical";
  const Reach reach = closed_form;
  table.take("soft_sand", domain, reach, soft.bulk_modulus, bound(K, K_s, s, 4 * G / 3), at);
  table.take("soft_sand", domain, reach, soft.shear_modulus, bound(G, G_s, s, zeta(K, G)), at);
  table.take("stiff_sand", domain, reach, stiff.bulk_modulus, bound(K, K_s, s, 4 * G_s / 3), at);
  table.take("stiff_sand", domain, reach, stiff.shear_modulus, bound(G, G_s, s, zeta(K_s, G_s)), at);
}

/// Mean of x^n (e0 + e3 x^2)^(1/2) over x from 0 to 1 by the recurrence of its source, with digits to spare
/// for what it cancels.
struct RootMeans {
  Real m0, m2, m4;
  RootMeans(const Real& e0, const Real& e3) {
    const Real q = e0 / e3, root = sqrt(1 + q);
    const Real logarithm = q > 0 ? Real(q * log((1 + root) / sqrt(q))) : Real(0);
    m0 = sqrt(e3) * (root + logarithm) / 2;
    m2 = (sqrt(e3) * (1 + q) * root - q * m0) / 4;
    m4 = (sqrt(e3) * (1 + q) * root - 3 * q * m2) / 6;
  }
};

void check_norris_johnson(Table& table, const SpherePacking& p, double e0, double e3) {
  const granum::rock_physics::StrainedPacking pack{.shear_modulus = p.shear_modulus,
                                                   .poisson_ratio = p.poisson_ratio,
                                                   .porosity = p.porosity,
                                                   .coordination_number = p.coordination_number,
                                                   .hydrostatic_strain = e0,
                                                   .uniaxial_strain = e3};
  const RootMeans J(e0, e3);
  const Real nu = p.poisson_ratio, r = 2 * (1 - nu) / (2 - nu);
  const Real kappa =
      3 * Real(p.coordination_number) * (1 - Real(p.porosity)) * Real(p.shear_modulus) / (pi() * (1 - nu));
  const Real n1122 = (J.m0 - 2 * J.m2 + J.m4) / 8, n1133 = (J.m2 - J.m4) / 2, n11 = (J.m0 - J.m2) / 2;
  const auto c = norris_johnson(pack).stiffness;
  const std::string at = said_of(p) + " " + said({{"e0", e0}, {"e3", e3}});
  const std::string domain = "e0/e3 1e-8 to 1e8";
  const Reach reach = stiffness_form;
  table.take("norris_johnson", domain, reach, c.C33, kappa * ((1 - r) * J.m4 + r * J.m2), at);
  table.take("norris_johnson", domain, reach, c.C11, kappa * (3 * (1 - r) * n1122 + r * n11), at);
  table.take("norris_johnson", domain, reach, c.C44, kappa * ((1 - r) * n1133 + r * (n11 + J.m2) / 4), at);
}

} // namespace

void check_sphere_packs(Table& table, std::size_t samples) {
  Draw draw(6);
  for (std::size_t k = 0; k < samples; ++k) {
    const SpherePacking p = draw_pack(draw);
    check_hertz_mindlin(table, p, draw.uniform_or(0, 1, {0.0, 1.0}));
    check_digby(table, p, draw.log_uniform(1e-9, 0.99));
    check_sand(table, p, p.porosity * draw.uniform(0.01, 0.99));
    const double e = draw.log_uniform(1e-12, 1e-2), ratio = draw.log_uniform(1e-8, 1e8);
    check_norris_johnson(table, p, e * ratio / (1 + ratio), e / (1 + ratio));
  }
}

} // namespace accuracy
