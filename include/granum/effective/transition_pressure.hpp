// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <granum/effective/state.hpp>

namespace granum::effective {

/// Mean stress p* at which X = u0 k_H/f is 1 at the mean force of rough spheres: below it roughness
/// determines the contact stiffness, above it Hertz' law. For equal spheres
/// sqrt(3)/(4 pi) C_n/(1+e) G/(1-nu) (u0/R)^(3/2),
/// Goddard's scaling with its constant.                                                        [Goddard1990]
/// Assumes   constant C_n and e; the stresses of the state are not used.
/// \return   p* [Pa]; empty for any other contact law
/// \throws   InvalidArgument as require_valid(State), and if C_n = 0
/// Accuracy  relative 1e-14.  Checked by tests/effective/test_transition_pressure.cpp
[[nodiscard]] std::optional<double> transition_pressure(const State& state);

/// p* of rough spheres whose moduli grow as p^s at the given mean stress, with a constant number of contacts:
/// solves b(X) = s, where X decreases as p^(-2/3).
/// \param    exponent      s in (1/3, 1) [1]
/// \param    mean_stress   p > 0 [Pa]
/// \return   [Pa]
/// \throws   InvalidArgument outside of these ranges, and for s within 1e-9 of an end
/// Accuracy  relative 1e-9.  Checked by tests/effective/test_transition_pressure.cpp
[[nodiscard]] double transition_pressure_of(double exponent, double mean_stress);

/// Roughness u0 of the grains of a packing with a known p*.
/// \param    state   its radius, grain material, C_n and e are used
/// \param    transition_pressure   p* > 0 [Pa]
/// \return   [m]
/// \throws   InvalidArgument as transition_pressure(State), and for p* out of range
/// Accuracy  relative 1e-14.  Checked by tests/effective/test_transition_pressure.cpp
[[nodiscard]] double roughness_of(State state, double transition_pressure);

} // namespace granum::effective
