// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing.hpp"

#include <algorithm>

#include <boost/math/special_functions/gamma.hpp>

namespace accuracy {

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
  drawn.where = said({{"alpha", alpha},
                      {"a", a},
                      {"r", s.tangential_ratio},
                      {"stress_v", s.stress_v},
                      {"stress_h", s.stress_h},
                      {"R", s.radius},
                      {"C_n", *s.coordination_number}});
  return drawn;
}

Real coefficient(const Packing& p) {
  const Real log_g =
      boost::math::lgamma((p.alpha + 1) / 2) - boost::math::lgamma(p.alpha / 2 + 1) - log(2 * sqrt(pi()));
  return 2 * p.G / (1 - p.nu) * p.alpha / (p.alpha + 1) * exp((log_g - log(p.profile)) / p.alpha);
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

Real bulk_modulus(const Five& c) { return (2 * c.C11 + c.C33 + 2 * c.C12 + 4 * c.C13) / 9; }

Real modulus(const Five& c, Modulus which) {
  switch (which) {
  case Modulus::K:
    return bulk_modulus(c);
  case Modulus::G_hh:
    return (c.C11 - c.C12) / 2;
  case Modulus::G_vh:
    return c.C44;
  case Modulus::E_v:
    return c.C33 - 2 * c.C13 * c.C13 / (c.C11 + c.C12);
  case Modulus::E_h: {
    const Real determinant = (c.C11 - c.C12) * ((c.C11 + c.C12) * c.C33 - 2 * c.C13 * c.C13);
    return determinant / (c.C11 * c.C33 - c.C13 * c.C13);
  }
  case Modulus::C11:
    return c.C11;
  case Modulus::C33:
    return c.C33;
  case Modulus::C12:
    return c.C12;
  case Modulus::C13:
    return c.C13;
  }
  return 0;
}

void compare(Table& table, const std::string& function, const std::string& domain, Reach reach,
             const granum::elastic::TransverselyIsotropic& c, const Five& reference, const std::string& at) {
  table.take(function + " C11, C33", domain, reach, c.C11, reference.C11, at);
  table.take(function + " C11, C33", domain, reach, c.C33, reference.C33, at);
  table.take(function + " C44, C66", domain, reach, c.C44, reference.C44, at);
  table.take_against(function + " C44, C66", domain, reach, c.C66(), (reference.C11 - reference.C12) / 2,
                     reference.C11, at);
  table.take_against(function + " C12 (of C11)", domain, reach, c.C12, reference.C12, reference.C11, at);
  table.take_against(function + " C13 (of root C11 C33)", domain, reach, c.C13, reference.C13,
                     sqrt(reference.C11 * reference.C33), at);
  table.take(function + " K", domain, reach, c.bulk_modulus(), bulk_modulus(reference), at);
}

} // namespace accuracy
