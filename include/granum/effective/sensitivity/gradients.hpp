// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include <granum/effective/exponents.hpp>
#include <granum/effective/model.hpp>
#include <granum/effective/state.hpp>

/// Exact derivatives of the closed forms: how much a modulus changes with each of its inputs.
namespace granum::effective {

/// An input that a modulus is differentiated by. Each of them varies alone, except mean_stress, which moves
/// both stresses at their ratio, and grain_poisson_ratio_mindlin.
enum class Input {
  mean_stress,                   ///< p = (stress_v + 2 stress_h)/3 [Pa]
  stress_v,                      ///< [Pa]
  stress_h,                      ///< [Pa]
  coordination_number,           ///< C_n
  void_ratio,                    ///< e
  fabric_anisotropy,             ///< a
  alpha,                         ///< at constant profile A_alpha, 0 for the flat punch of constant radius
  grain_shear_modulus,           ///< G_g [Pa]
  grain_poisson_ratio,           ///< nu_g at constant k_t/k_n
  grain_poisson_ratio_mindlin,   ///< nu_g if k_t/k_n = 2(1-nu)/(2-nu) follows it
  tangential_ratio,              ///< k_t/k_n
  radius,                        ///< R of the packing [m], the contact law kept as it is
  mechanical_coordination_number ///< z*, which rung 3 alone depends on
};
inline constexpr std::size_t input_count = 13;

/// A modulus and its derivatives.
struct Gradient {
  double value = 0;                     ///< the modulus [Pa]
  std::array<double, input_count> by{}; ///< dX/d input in the order of Input [Pa by unit of the input]

  [[nodiscard]] double operator[](Input input) const { return by[static_cast<std::size_t>(input)]; }
  [[nodiscard]] double& operator[](Input input) { return by[static_cast<std::size_t>(input)]; }
};

/// Gradient of a product, for instance of a modulus and a factor that depends on the same inputs.
/// Checked by tests/effective/test_gradients.cpp
[[nodiscard]] Gradient operator*(const Gradient& x, const Gradient& y);

/// A modulus of a model with its derivatives by every input, differentiated exactly under the integral.
///                                                                                [Chung2014; ChangLiao1994]
/// \throws   InvalidArgument as require_valid(State); for a law that is none of the power family, whose numbers
///           are no Input; without stress or contacts, where a derivative may be
///           infinite; for E_v and E_h of uniform stress at k_t = 0, where they vanish
/// Accuracy  relative 1e-11 of the largest logarithmic derivative.
///           Checked by tests/effective/test_gradients.cpp
[[nodiscard]] Gradient gradient(const State& state, const Model& model, Modulus which);

/// A modulus with its derivatives, and what the calibration of its estimate leaves open of it.
struct CalibratedGradient {
  Gradient gradient;
  double standard_error = 0; ///< of the calibration alone, the inputs taken as exact; 0 without one [Pa]
};

/// A modulus of relaxed(state, z*), rung 3, with its exact derivatives by every input; each varies alone: z*
/// stays where C_n moves. The standard error combines those of the two factors and of the stretch, taken as
/// independent, to first order; that of G_vh and G_hh is the one of relaxed().
/// \param    mechanical_coordination_number   z* [1]
/// \throws   InvalidArgument as gradient and relaxed, and if z* is not above the isostatic point, where every
///           modulus vanishes
/// Accuracy  relative 1e-11 of the largest logarithmic derivative.
///           Checked by tests/effective/test_relaxed_gradients.cpp
[[nodiscard]] CalibratedGradient relaxed_gradient(const State& state, double mechanical_coordination_number,
                                                  Modulus which);

} // namespace granum::effective
