// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace granum::hardin {

/// Void-ratio functions f(e) of Eq. (1) that are in use. None depends on units.
enum class VoidRatioFunction {
  hardin_richart_round,   ///< (2.17-e)^2/(1+e), rounded grains; the paper's choice  [HardinRichart1963]
  hardin_richart_angular, ///< (2.97-e)^2/(1+e), angular grains                      [HardinRichart1963]
  power_1_3,              ///< e^-1.3                                                [Jamiolkowski1991]
  hardin_blandford,       ///< 1/(0.3+0.7 e^2)                           [Hardin1978; HardinBlandford1989]
  none,                   ///< 1
};

/// f(e).
/// \param    void_ratio  e > 0 [1]; the Hardin-Richart forms also need e below 2.17 and 2.97, where
///                       they reach zero
/// \throws   InvalidArgument outside that range
/// Accuracy  4 ulp.  Checked by tests/hardin/test_equation.cpp
[[nodiscard]] double void_ratio_value(VoidRatioFunction function, double void_ratio);

/// The names that programs accept: hardin-richart-round, hardin-richart-angular, power-1.3,
/// hardin-blandford, none.
[[nodiscard]] std::string_view name(VoidRatioFunction function);
/// \throws   InvalidArgument for an unknown name; the text lists the known ones.
[[nodiscard]] VoidRatioFunction void_ratio_function(std::string_view name);
[[nodiscard]] std::vector<VoidRatioFunction> all_void_ratio_functions();

/// \file
/// The empirical small-strain shear modulus of soils.
/// Checked by tests/hardin/test_equation.cpp

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

/// y = c_0 + c_1 x + c_2 x^2 + ... by least squares.
struct Polynomial {
  std::vector<double> coefficients; ///< c_0, c_1, ... in units of y over powers of x
  double rms = 0;                   ///< distance of the points from the curve, in units of y
};

/// Assumes   x of order 1, shifted near its middle: powers of large numbers lose digits.
/// \param    x, y    as many of each, at least degree + 1 points
/// \param    degree  in [0, 8]
/// \throws   InvalidArgument outside these ranges, for an x or y that is not finite, and where x to the
///           degree or y is beyond 1e150; NotConverged if the least squares fail
/// GSL reports its errors to this function alone: a handler of the program is neither called nor replaced.
/// Accuracy  points on a polynomial give its coefficients to 1e-12 where abs(x) <= 2.
/// Checked by tests/hardin/test_equation.cpp
[[nodiscard]] Polynomial fit_polynomial(std::span<const double> x, std::span<const double> y,
                                        std::size_t degree);

} // namespace granum::hardin
