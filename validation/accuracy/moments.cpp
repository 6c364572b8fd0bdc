// SPDX-License-Identifier: GPL-3.0-or-later
#include "moments.hpp"

#include <boost/math/quadrature/tanh_sinh.hpp>

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
  const Real n1122 = (w.m0 - 2 * w.m2 + w.m4) / 8, n1133 = (w.m2 - w.m4) / 2, n11 = (w.m0 - w.m2) / 2;
  return {scale * (3 * n1122 + r * (n11 - 3 * n1122)), scale * (w.m4 + r * (w.m2 - w.m4)),
          scale * (1 - r) * n1122, scale * (1 - r) * n1133, scale * ((1 - r) * n1133 + r * (n11 + w.m2) / 4)};
}

Five free_spin_stiffness(const Real& scale, const Real& r, const Moments& w) {
  // Displacement u = (e + W) n, e13 = 1/2, W13 = -W31 = x. Energy <w (u_n^2 + r u_t^2)>, with
  // u_1 = (1/2+x) n3, u_3 = (1/2-x) n1 and u_n = n1 n3; its minimum over x lies at
  // x = (A1-A3)/(2 (A1+A3)), A_i = <w n_i^2>.
  const Real n1133 = (w.m2 - w.m4) / 2, A1 = (w.m0 - w.m2) / 2, A3 = w.m2;
  const Real x = (A1 - A3) / (2 * (A1 + A3)), half = Real(1) / 2;
  const Real squares = (half + x) * (half + x) * A3 + (half - x) * (half - x) * A1;
  Five c = strain_stiffness(scale, r, w);
  c.C44 = scale * (n1133 + r * (squares - n1133));
  return c;
}

Five stress_stiffness(const Real& scale, const Real& r, const Moments& fabric, const Moments& w) {
  // Forces of unit stresses: f_i = n_i/F_ii along the axis. Energy: f_n^2 + (f^2 - f_n^2)/r.
  const Real F33 = fabric.m2, F11 = (1 - F33) / 2;
  const Real n1122 = (w.m0 - 2 * w.m2 + w.m4) / 8, n1133 = (w.m2 - w.m4) / 2, n11 = (w.m0 - w.m2) / 2;
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

} // namespace accuracy
