// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/effective/exponents.hpp>
#include <granum/effective/state.hpp>

#include "moments.hpp"

/// A packing of any of the numbers of State, in 50-digit arithmetic, and its stiffness.
namespace accuracy {

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

/// c of f = c d^(1+1/alpha).
Real coefficient(const Packing& p);
/// P = N_c l^2/V.
Real prefactor(const Packing& p);
/// k_n at the overlap d.
Real stiffness_at_overlap(const Packing& p, const Real& d);
/// Stiffness with the stiffness of contacts taken at their static forces.
Five static_stiffness(const Packing& p, granum::effective::Hypothesis hypothesis);

Real bulk_modulus(const Five& c);
/// The modulus of that name.
Real modulus(const Five& c, granum::effective::Modulus which);

/// Compares the five constants; C12 and C13 against the larger C11 and root C11 C33.
void compare(Table& table, const std::string& function, const std::string& domain, Reach reach,
             const granum::elastic::TransverselyIsotropic& c, const Five& reference, const std::string& at);

} // namespace accuracy
