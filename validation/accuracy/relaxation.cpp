// SPDX-License-Identifier: GPL-3.0-or-later
// The recorded coefficients put into the formulas of validation/relaxation/README.md; their calibration is
// checked there.
#include <granum/effective/relaxation.hpp>

#include "effective/relaxation_coefficients.hpp"
#include "matrices.hpp"
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
  const At at{table, "z* above isostatic to 14 and 1e6, k_t/k_n 0 to 2", said("z r b", {z, r, b}),
              quadrature};
  at("relaxation of G", factors.shear.value, shear_factor(z, r, b));
  at("relaxation of K", factors.bulk.value, bulk_factor(z, r, b));
}

/// S M C M S: M scales volumetric and deviatoric strain by sqrt K and sqrt G, S = diag(q, q, q^-2) stretches
/// C33/C11 by q^-6 = exp(log_stretch). Where K comes out above that of C, its bound, all is scaled down to
/// it.
Five relaxed_stiffness(const Five& c, const Real& K, const Real& G, const Real& log_stretch) {
  const Real3 stiffness{{{c.C11, c.C12, c.C13}, {c.C12, c.C11, c.C13}, {c.C13, c.C13, c.C33}}};
  Real3 filter{};
  Real3::each([&](int i, int j) { filter[i][j] = (i == j ? sqrt(G) : Real(0)) + (sqrt(K) - sqrt(G)) / 3; });
  const Real3 left = filter * stiffness * filter;
  const Real q = exp(-log_stretch / 6), v = 1 / (q * q);
  const Five free{q * q * left[0][0], v * v * left[2][2], q * q * left[0][1], q * v * left[0][2],
                  q * v * G * c.C44};
  const Real bound = c.nine_bulk_moduli(), above = free.nine_bulk_moduli();
  return free.times(above > bound ? Real(bound / above) : Real(1));
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
  compare({table, "forces 1 to 1e4 apart, a in [-1, 1]", drawn.where + " " + said("z", {z}), quadrature},
          "relaxed", granum::effective::relaxed(drawn.state, z).stiffness,
          relaxed_stiffness(strained, K, G, log_stretch).times(shortened_branches(p)));
}

} // namespace

void check_relaxation(Table& table, Draw& draw, std::size_t k) {
  check_factors(table, draw);
  if (k % 200 == 0)
    check_relaxed(table, draw);
}

} // namespace accuracy
