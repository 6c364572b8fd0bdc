// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing.hpp"

#include <algorithm>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/gamma.hpp>

namespace accuracy {

Moments fabric_moments(const Real& a) {
  const auto mean = [&](int n) { return Real(3 / (3 - a) * ((1 - a) / (n + 1) + 2 * a / (n + 3))); };
  return {1, mean(2), mean(4)};
}

Moments weighted_moments(const Real& a, const Real& h, const Real& b) {
  static boost::math::quadrature::tanh_sinh<Real> integrator(12);
  const auto mean = [&](int n) {
    const auto integrand = [&](const Real& x) {
      const Real x2 = x * x;
      return Real(3 / (3 - a) * (1 - a + 2 * a * x2) * pow(h * (1 - x2) + x2, b) * pow(x, n));
    };
    return integrator.integrate(integrand, Real(0), Real(1), Real(1e-25));
  };
  return {mean(0), mean(2), mean(4)};
}

Five strain_stiffness(const Real& scale, const Real& r, const Moments& w) {
  const Real n1122 = w.n1122(), n1133 = w.n1133(), n11 = w.n11();
  return {scale * (3 * n1122 + r * (n11 - 3 * n1122)), scale * (w.m4 + r * (w.m2 - w.m4)),
          scale * (1 - r) * n1122, scale * (1 - r) * n1133, scale * ((1 - r) * n1133 + r * (n11 + w.m2) / 4)};
}

Five free_spin_stiffness(const Real& scale, const Real& r, const Moments& w) {
  // Displacement u = (e + W) n, e13 = 1/2, W13 = -W31 = x. Energy <w (u_n^2 + r u_t^2)>, with
  // u_1 = (1/2+x) n3, u_3 = (1/2-x) n1 and u_n = n1 n3; its minimum over x lies at
  // x = (A1-A3)/(2 (A1+A3)), A_i = <w n_i^2>.
  const Real n1133 = w.n1133(), A1 = w.n11(), A3 = w.m2;
  const Real x = (A1 - A3) / (2 * (A1 + A3)), half = Real(1) / 2;
  const Real squares = (half + x) * (half + x) * A3 + (half - x) * (half - x) * A1;
  Five c = strain_stiffness(scale, r, w);
  c.C44 = scale * (n1133 + r * (squares - n1133));
  return c;
}

Five stress_stiffness(const Real& scale, const Real& r, const Moments& fabric, const Moments& w) {
  // Forces of unit stresses: f_i = n_i/F_ii along the axis. Energy: f_n^2 + (f^2 - f_n^2)/r.
  const Real F33 = fabric.m2, F11 = (1 - F33) / 2;
  const Real n1122 = w.n1122(), n1133 = w.n1133(), n11 = w.n11();
  const Real q = 1 - 1 / r;
  const Real S11 = (q * 3 * n1122 + n11 / r) / (F11 * F11), S33 = (q * w.m4 + w.m2 / r) / (F33 * F33);
  const Real S12 = q * n1122 / (F11 * F11), S13 = q * n1133 / (F11 * F33);
  // A unit shear stress s13 = s31: f = (n3/F33, 0, n1/F11).
  const Real pair = 1 / F11 + 1 / F33;
  const Real S44 = q * pair * pair * n1133 + (w.m2 / (F33 * F33) + n11 / (F11 * F11)) / r;
  const Real determinant = (S11 + S12) * S33 - 2 * S13 * S13;
  const Real sum = S33 / determinant, difference = 1 / (S11 - S12); // C11 + C12, C11 - C12
  return {scale * (sum + difference) / 2, scale * (S11 + S12) / determinant, scale * (sum - difference) / 2,
          -scale * S13 / determinant, scale / S44};
}

using granum::effective::Hypothesis;
using granum::effective::Modulus;

PackingCase draw_packing(Draw& draw) {
  const granum::contact::GrainMaterial grain{draw.log_uniform(1e6, 1e12), draw.poisson_ratio()};
  const double alpha = draw.uniform_or(1, 8, {1.0, 2.0, 100.0}), profile = draw.log_uniform(1, 1e4);
  const double a = draw.anisotropy(), p = draw.log_uniform(1, 1e7);
  // vertical over horizontal static force is F11/F33 of the ratio of stresses
  const double force_ratio = draw.uniform_or(0, 1, {0.0, 0.5, 1.0});
  const double F33 = (5 + a) / (5 * (3 - a)), F11 = (1 - F33) / 2;
  const double stress_ratio = std::pow(0.9e4, 2 * force_ratio - 1) * F33 / F11;
  PackingCase drawn{.state = {.law = granum::contact::PowerLaw::general(grain, alpha, profile),
                              .tangential_ratio = draw.ratio(),
                              .radius = draw.log_uniform(1e-9, 1e3),
                              .void_ratio = draw.log_uniform(0.05, 5),
                              .coordination_number = draw.coordination_number(),
                              .fabric_anisotropy = a,
                              .stress_v = p * std::min(1.0, stress_ratio),
                              .stress_h = p / std::max(1.0, stress_ratio)},
                    .packing = {},
                    .where = {}};
  const auto& s = drawn.state;
  drawn.packing = {
      grain.shear_modulus, grain.poisson_ratio,    alpha, profile,    s.tangential_ratio, s.radius,
      s.void_ratio,        *s.coordination_number, a,     s.stress_v, s.stress_h};
  drawn.where = said("alpha a r stress_v stress_h R C_n", {alpha, a, s.tangential_ratio, s.stress_v,
                                                           s.stress_h, s.radius, *s.coordination_number});
  return drawn;
}

Real coefficient(const Real& bulk, const Real& alpha, const Real& profile) {
  const Real log_g =
      boost::math::lgamma((alpha + 1) / 2) - boost::math::lgamma(alpha / 2 + 1) - log(2 * sqrt(pi()));
  return 2 * bulk * alpha / (alpha + 1) * exp((log_g - log(profile)) / alpha);
}
Real coefficient(const Packing& p) { return coefficient(p.G / (1 - p.nu), p.alpha, p.profile); }

Moduli hertzian(const granum::contact::GrainMaterial& grain, const Real& contacts, const Real& p,
                const Real& r) {
  const Real m = contacts * Real(grain.shear_modulus) / (1 - Real(grain.poisson_ratio));
  const Real K = cbrt(m * m * p / (18 * pi() * pi()));
  return {K, K * 3 * (2 + 3 * r) / 10};
}

Real prefactor(const Packing& p) { return 3 * p.C / (2 * pi() * p.R * (1 + p.e)); }

Real stiffness_at_overlap(const Packing& p, const Real& d) {
  return (1 + 1 / p.alpha) * coefficient(p) * pow(d, 1 / p.alpha);
}

Five static_stiffness(const Packing& p, Hypothesis hypothesis) {
  const Moments fabric = fabric_moments(p.a);
  const Real F33 = fabric.m2, F11 = (1 - F33) / 2;
  const Real vertical = 2 * p.R / prefactor(p) * p.stress_v / F33;
  const Real spread = p.stress_h / F11 / (p.stress_v / F33), b = 1 / (1 + p.alpha);
  const Real k = stiffness_at_overlap(p, pow(vertical / coefficient(p), p.alpha * b));
  const Real scale = prefactor(p) * k;
  if (hypothesis == Hypothesis::uniform_stress)
    return stress_stiffness(scale, p.r, fabric, weighted_moments(p.a, spread, -b));
  const Moments w = weighted_moments(p.a, spread, b);
  return hypothesis == Hypothesis::free_spin ? free_spin_stiffness(scale, p.r, w)
                                             : strain_stiffness(scale, p.r, w);
}

Real modulus(const Five& c, Modulus which) {
  const Real determinant = (c.C11 - c.C12) * ((c.C11 + c.C12) * c.C33 - 2 * c.C13 * c.C13);
  switch (which) {
  case Modulus::K:
    return c.nine_bulk_moduli() / 9;
  case Modulus::G_hh:
    return (c.C11 - c.C12) / 2;
  case Modulus::G_vh:
    return c.C44;
  case Modulus::E_v:
    return c.C33 - 2 * c.C13 * c.C13 / (c.C11 + c.C12);
  case Modulus::E_h:
    return determinant / (c.C11 * c.C33 - c.C13 * c.C13);
  default:
    return 0;
  }
}

void compare(const At& at, const std::string& function, const granum::elastic::TransverselyIsotropic& c,
             const Five& reference) {
  at(function + " C11, C33", c.C11, reference.C11);
  at(function + " C11, C33", c.C33, reference.C33);
  at(function + " C44, C66", c.C44, reference.C44);
  at.of(reference.C11, function + " C44, C66", c.C66(), (reference.C11 - reference.C12) / 2);
  at.of(reference.C11, function + " C12 (of C11)", c.C12, reference.C12);
  at.of(sqrt(reference.C11 * reference.C33), function + " C13 (of root C11 C33)", c.C13, reference.C13);
  at(function + " K", c.bulk_modulus(), reference.nine_bulk_moduli() / 9);
}

} // namespace accuracy
