// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <granum/effective/state.hpp>
#include <granum/elastic/transverse_isotropic.hpp>

namespace granum::effective {

/// Moduli whose growth with stress is computed. G_vh = G_hv = C44, G_hh = C66.
enum class Modulus { K, G_hh, G_vh, E_v, E_h, C11, C33, C12, C13 };

/// Local exponents of a modulus X at a state of constant C_n, e and a. Of G_ij = const sigma_i^m sigma_j^n
/// the exponent m belongs to i: for G_hv, m = stress_h and n = stress_v; for G_vh, m = stress_v and
/// n = stress_h.
struct StressExponents {
  double stress_v = 0; ///< d ln X/d ln stress_v
  double stress_h = 0; ///< d ln X/d ln stress_h
  /// s = d ln X/d ln p at constant stress ratio; 1/(1+alpha) for every X.
  [[nodiscard]] double sum() const { return stress_v + stress_h; }
};

/// The modulus of that name [Pa].
/// \throws   InvalidArgument for a Young's modulus of a stiffness that is not positive definite
[[nodiscard]] double modulus(const elastic::TransverselyIsotropic& stiffness, Modulus which);
/// The same for any stiffness: Young's moduli according to elastic::young_modulus, empty where undefined.
[[nodiscard]] std::optional<double> modulus_if_any(const elastic::TransverselyIsotropic& stiffness,
                                                   Modulus which);

/// Exponents of a modulus of uniform_strain(state), differentiated exactly under the integral.    [Chung2014]
/// \throws   InvalidArgument as require_valid(State), without stress or contacts, and where the modulus is
///           zero, as C12 and C13 at k_t = k_n
/// Accuracy  1e-12 absolute.  Checked by tests/effective/test_exponents.cpp
[[nodiscard]] StressExponents uniform_strain_exponents(const State& state, Modulus which);

/// Exponents of a modulus of free_spin(state).
/// \throws   InvalidArgument as uniform_strain_exponents
/// Accuracy  1e-12 absolute.  Checked by tests/effective/test_exponents.cpp
[[nodiscard]] StressExponents free_spin_exponents(const State& state, Modulus which);

/// Exponents of a modulus of uniform_stress(state).
/// \throws   InvalidArgument as uniform_strain_exponents, and for G and E at k_t = 0, where they vanish
/// Accuracy  1e-12 absolute; of G_hh, E_v and E_h 1e-12 (1 + 1/r), r = k_t/k_n, and none below r = 1e-13.
///            Checked by tests/effective/test_exponents.cpp
[[nodiscard]] StressExponents uniform_stress_exponents(const State& state, Modulus which);

} // namespace granum::effective
