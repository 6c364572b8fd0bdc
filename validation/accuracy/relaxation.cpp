// SPDX-License-Identifier: GPL-3.0-or-later
// The recorded coefficients put into the formulas of validation/relaxation/README.md; their calibration is
// checked there.
#include <granum/effective/relaxation.hpp>

#include "effective/relaxation_coefficients.hpp"
#include "packing.hpp"

namespace accuracy {

namespace {

namespace kernel = granum::effective::kernel;

/// The least of b and 1/2, from where on other packings say how the factors go on.
Real up_to_half(const Real& b) { return b < 0.5 ? b : Real(0.5); }

/// The positive root h of ((2+3r)/2 h)^2 - g0 (2+3r)/2 h = r t.
Real shear_factor(const Real& z, const Real& r, const Real& b) {
  const auto& c = kernel::shear_coefficients;
  const Real x = z - c[7], u = z - 6;
  if (x <= 0 || (r == 0 && u <= 0))
    return 0;
  const Real g0 = u > 0 ? c[0] * u / (1 + c[0] * u) : c[0] * u / (1 - c[1] * u);
  const Real near = 1 / (1 + pow(x / c[6], Real(5) / 2));
  const Real t = near * c[2] * (1 - c[5] * pow(up_to_half(b), 2)) * x / ((1 + c[3] * x) * (1 + c[4] * r)) +
                 (1 - near) * (6 + 9 * r) / 4;
  const Real h = (g0 + sqrt(g0 * g0 + 4 * r * t)) / (2 + 3 * r);
  return b > 0.5 ? Real(h * exp(-kernel::power_law_losses[0] * (1 - h) * (2 * b - 1))) : h;
}

Real bulk_factor(const Real& z, const Real& r, const Real& b) {
  const auto& c = kernel::bulk_coefficients;
  const Real x = z - c[3];
  const Real left = b > 0.5 ? Real(pow(2 - 2 * b, Real(kernel::power_law_losses[1]))) : Real(1);
  return 1 / (1 + c[0] * left / (z - c[1] + c[5] * up_to_half(b)) + c[2] / (x * x * (r + c[4] * x * x)));
}

void check_factors(Table& table, Draw& draw) {
  const double r = draw.ratio(), b = draw.uniform_or(0, 1, {0.0, 1.0 / 3, 0.5, 1.0});
  const double z = draw.uniform_or(r > 0 ? 3.958 : 6.001, 14, {8.7, 14.0, 1e6});
  const auto factors = granum::effective::relaxation(z, r, b);
  const std::string at = said({{"z", z}, {"r", r}, {"b", b}});
  const std::string domain = "z* above isostatic to 14 and 1e6, k_t/k_n 0 to 2";
  table.take("relaxation of G", domain, quadrature, factors.shear.value, shear_factor(z, r, b), at);
  table.take("relaxation of K", domain, quadrature, factors.bulk.value, bulk_factor(z, r, b), at);
}

struct Block {
  Real of[3][3];
};
Block product(const Block& a, const Block& b) {
  Block c{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k)
        c.of[i][j] += a.of[i][k] * b.of[k][j];
  return c;
}

Real nine_bulk_moduli(const Five& c) { return 2 * c.C11 + c.C33 + 2 * c.C12 + 4 * c.C13; }

/// S M C M S: M scales volumetric and deviatoric strain by sqrt K and sqrt G, S = diag(q, q, q^-2) stretches
/// C33/C11 by q^-6 = exp(log_stretch). Where K comes out above that of C, its bound, all is scaled down to
/// it.
Five relaxed_stiffness(const Five& c, const Real& K, const Real& G, const Real& log_stretch) {
  const Real C[3][3] = {{c.C11, c.C12, c.C13}, {c.C12, c.C11, c.C13}, {c.C13, c.C13, c.C33}};
  Block stiffness{}, filter{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      stiffness.of[i][j] = C[i][j];
      filter.of[i][j] = (i == j ? sqrt(G) : Real(0)) + (sqrt(K) - sqrt(G)) / 3;
    }
  const Block left = product(product(filter, stiffness), filter);
  const Real q = exp(-log_stretch / 6), v = 1 / (q * q);
  const Five free{q * q * left.of[0][0], v * v * left.of[2][2], q * q * left.of[0][1], q * v * left.of[0][2],
                  q * v * G * c.C44};
  const Real bound = nine_bulk_moduli(c), above = nine_bulk_moduli(free);
  const Real share = above > bound ? Real(bound / above) : Real(1);
  return {share * free.C11, share * free.C33, share * free.C12, share * free.C13, share * free.C44};
}

Five scaled(const Five& c, const Real& by) {
  return {by * c.C11, by * c.C33, by * c.C12, by * c.C13, by * c.C44};
}

/// What is left of the moduli at branches that overlaps at the mean force shorten, by a tenth at most.
Real shortened_branches(const Packing& p) {
  const Real area = 4 * pi() * p.R * p.R * (1 + p.e) / p.C;
  const Real force = area * (p.stress_v + 2 * p.stress_h) / 3, b = 1 / (1 + p.alpha);
  const Real overlap = pow(force / coefficient(p), p.alpha * b) / (2 * p.R), most = Real(1) / 10;
  return pow(1 - (overlap < most ? overlap : most), 2 - b);
}

void check_relaxed(Table& table, Draw& draw) {
  const PackingCase drawn = draw_packing(draw);
  const double z = draw.uniform(drawn.state.tangential_ratio > 0 ? 4.0 : 6.1, 14);
  const Packing& p = drawn.packing;
  const Real b = 1 / (1 + p.alpha), G = shear_factor(z, p.r, b), K = bulk_factor(z, p.r, b);
  const Real F33 = fabric_moments(p.a).m2, F11 = (1 - F33) / 2;
  const auto& c = kernel::stretch_coefficients;
  const Real log_stretch = (1 - G) * (c[0] * log(F33 / F11) + c[1] * b * log(p.stress_v / p.stress_h));
  const Five strained = static_stiffness(p, granum::effective::Hypothesis::uniform_strain);
  compare(table, "relaxed", "forces 1 to 1e4 apart, a in [-1, 1]", quadrature,
          granum::effective::relaxed(drawn.state, z).stiffness,
          scaled(relaxed_stiffness(strained, K, G, log_stretch), shortened_branches(p)),
          drawn.where + " " + said({{"z", z}}));
}

} // namespace

void check_relaxation(Table& table, std::size_t samples) {
  Draw draw(10);
  for (std::size_t k = 0; k < samples; ++k) {
    check_factors(table, draw);
    if (k % 200 == 0)
      check_relaxed(table, draw);
  }
}

} // namespace accuracy
