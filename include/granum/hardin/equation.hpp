// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/hardin/void_ratio_function.hpp>

/// The empirical small-strain shear modulus of soils.
/// Checked by tests/hardin/test_equation.cpp
namespace granum::hardin {

/// Where a modulus G_ij is wanted: the effective stresses along the direction i of propagation and j of
/// polarisation.
struct SoilState {
  double stress_i = 0;   ///< sigma_i > 0 [Pa]
  double stress_j = 0;   ///< sigma_j > 0 [Pa]
  double void_ratio = 0; ///< e > 0 [1]
};

/// G_ij = C p_a f(e) (sigma_i/p_a)^m (sigma_j/p_a)^n, Eq. (1).                              [Chung2014]
/// C is a pure number that depends on the choice of p_a; so p_a has no default.
struct Equation {
  double coefficient = 0;          ///< C > 0 [1]
  double exponent_i = 0;           ///< m [1]
  double exponent_j = 0;           ///< n [1]
  double atmospheric_pressure = 0; ///< p_a > 0 [Pa]
  VoidRatioFunction void_ratio_function = VoidRatioFunction::hardin_richart_round;
};

/// Eq. (1) at one state.
/// \return   G_ij [Pa]
/// \throws   InvalidArgument if a constant or a part of the state is outside its range
/// Accuracy  1e-15 relative for stresses within 1e-3 to 1e3 p_a.
[[nodiscard]] double shear_modulus(const Equation& equation, const SoilState& state);

} // namespace granum::hardin
