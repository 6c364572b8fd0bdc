// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/effective/exponents.hpp>
#include <granum/effective/state.hpp>

#include "harness.hpp"

/// Averages over directions in 50-digit arithmetic, the stiffness that belongs to them, and a packing of any
/// of the numbers of State.
namespace accuracy {

/// Means over E(gamma; a) of w, w x^2, w x^4, x = cos gamma.
struct Moments {
  Real m0, m2, m4;

  [[nodiscard]] Real n1122() const { return (m0 - 2 * m2 + m4) / 8; }
  [[nodiscard]] Real n1133() const { return (m2 - m4) / 2; }
  [[nodiscard]] Real n11() const { return (m0 - m2) / 2; }
};

/// w = 1.
Moments fabric_moments(const Real& a);
/// w = (h (1-x^2) + x^2)^b, by double-exponential quadrature.
Moments weighted_moments(const Real& a, const Real& h, const Real& b);

/// The five constants.
struct Five {
  Real C11, C33, C12, C13, C44;

  [[nodiscard]] Real nine_bulk_moduli() const { return 2 * C11 + C33 + 2 * C12 + 4 * C13; }
  [[nodiscard]] Five times(const Real& by) const {
    return {by * C11, by * C33, by * C12, by * C13, by * C44};
  }
};

/// Uniform strain: scale <w ((1-r) nnnn + r/4 (...))>.
Five strain_stiffness(const Real& scale, const Real& r, const Moments& w);
/// The same with the mean spin w of the grains free: C44 is the least over w of the energy of a strain e13.
Five free_spin_stiffness(const Real& scale, const Real& r, const Moments& w);
/// Uniform stress: the inverse of the compliance <w (f_n^2 + f_t^2/r)>/scale with f = F^-1 n; w = 1/k.
Five stress_stiffness(const Real& scale, const Real& r, const Moments& fabric, const Moments& w);

/// K and G of spheres without fabric from the pressure; contacts: C_n times the share of the spheres.
/// K^3 = (C phi G/(1-nu))^2 p/(18 pi^2), without force and radius.                             [Walton1987]
struct Moduli {
  Real K, G;
};
Moduli hertzian(const granum::contact::GrainMaterial& grain, const Real& contacts, const Real& p,
                const Real& r);

/// Members as in State, with the numbers that its contact law is made of.
struct Packing {
  Real G, nu, alpha, profile; ///< [Sneddon1965] with A_alpha = profile
  Real r, R, e, C, a, stress_v, stress_h;
};

/// A packing and the State that the library takes for it.
struct PackingCase {
  granum::effective::State state;
  Packing packing;
  std::string where;
};

/// Static contact forces up to 1e4 apart, any alpha from 1, fabric and contact ratio.
PackingCase draw_packing(Draw& draw);

/// c of f = c d^(1+1/alpha), G/(1-nu) being `bulk`.
Real coefficient(const Real& bulk, const Real& alpha, const Real& profile);
Real coefficient(const Packing& p);
/// P = N_c l^2/V.
Real prefactor(const Packing& p);
/// k_n at the overlap d.
Real stiffness_at_overlap(const Packing& p, const Real& d);
/// Stiffness with the stiffness of contacts taken at their static forces.
Five static_stiffness(const Packing& p, granum::effective::Hypothesis hypothesis);

/// The modulus of that name.
Real modulus(const Five& c, granum::effective::Modulus which);

/// Compares the five constants; C12 and C13 against the larger C11 and root C11 C33.
void compare(const At& at, const std::string& function, const granum::elastic::TransverselyIsotropic& c,
             const Five& reference);

} // namespace accuracy
