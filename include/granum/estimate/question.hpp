// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include <granum/effective/contact_prior.hpp>
#include <granum/effective/state.hpp>
#include <granum/sands/pooled_law.hpp>

/// The known properties of a packing whose stiffness is wanted.
namespace granum::estimate {

/// The kind of grains: spheres as in the model, or sand.
enum class GrainShape {
  sphere, ///< rung 3 of the model
  sand    ///< laws measured on sands, supplemented by mechanics
};
inline constexpr std::array all_grain_shapes{GrainShape::sphere, GrainShape::sand};
/// The name of the enumerator.
[[nodiscard]] std::string_view name(GrainShape shape);
/// \throws   InvalidArgument with all names for another text
[[nodiscard]] GrainShape grain_shape_of(std::string_view text);

/// A packing at one stress. Its contacts may be unknown, or given by one or two of C_n, z* and the fraction
/// of rattlers.
struct Question {
  effective::State state;                  ///< law, k_t/k_n, grains, e, a, stresses; C_n and z* if known
  effective::Preparation preparation = {}; ///< how the grains were brought together
  std::optional<double> rattler_fraction = std::nullopt; ///< x_0 in [0, 1), if known [1]
  std::optional<double> grain_density = std::nullopt;    ///< [kg/m3] > 0; without it no wave speeds
  double saturation = 0;                                 ///< degree of saturation, in [0, 1] [1]
  GrainShape grain_shape = GrainShape::sphere;
  sands::Sand sand = {}; ///< for sands: properties besides the state
  /// For sands: amplitude of a shear strain at which G is wanted as well, in (0, 0.05] [1].
  std::optional<double> shear_strain = std::nullopt;

  /// Whether a number of contacts or of rattlers is known.
  [[nodiscard]] bool knows_contacts() const {
    return state.coordination_number || state.mechanical_coordination_number || rattler_fraction;
  }
};

/// Refuses what no packing and no sand can be. Every answer begins with it, whatever program or table the
/// question comes from; a question that is changed by a standard deviation may be beyond these limits.
/// \throws   InvalidArgument as effective::require_valid and sands::require_density, for a saturation or
///           density out of its range, for stresses that friction of 70 degrees cannot hold, and, for
///           spheres, for a shear strain and C_u above sphere_uniformity_limit
/// Checked by tests/estimate/test_question.cpp
void require_valid(const Question& question);

/// Largest C_u of spheres for which the answer is valid.
inline constexpr double sphere_uniformity_limit = 4;

/// An uncertain input: the question with the input changed by one standard deviation to each side.
struct Spread {
  std::string input;    ///< its name
  bool assumed = false; ///< the input is not measured: its value and its deviation are assumptions
  Question less;        ///< the input decreased by one deviation
  Question more;        ///< the input increased by one deviation
};

/// The same, with a function that changes the question.
struct UncertainInput {
  std::string input;
  double deviation = 0; ///< one standard deviation >= 0 [unit of the input]
  bool assumed = false;
  std::function<Question(double change)> moved; ///< the question with the input changed by so much
};

/// The name of the fabric a as an input. A rung that needs it is not evaluated with an assumed fabric.
inline constexpr std::string_view fabric_input = "fabric";

/// Standard deviations of inputs that are not measured.
struct AssumedDeviations {
  double grain_shear_modulus = 0.3;  ///< relative: minerals from glass to quartz [1]
  double grain_poisson_ratio = 0.07; ///< of the same minerals [1]
  double grain_density = 50;         ///< of the minerals of sands [kg/m3]
};
inline constexpr AssumedDeviations assumed_deviations{};

/// Standard deviation of a fabric that is not measured: due to pouring and, under anisotropic stress, to
/// shear. For comparison, the root mean square of granum's specimens, which were made without a preferred
/// direction, is hypot(0.012, 0.2 ln(stress_v/stress_h)).
/// \return   hypot(0.05, 0.2 ln(stress_v/stress_h)); 0.05 without stress [1]
/// Checked by tests/estimate/test_ladder.cpp
[[nodiscard]] double assumed_fabric_deviation(double stress_v, double stress_h);

} // namespace granum::estimate
