// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Axisymmetric states of stress, for closed forms and experiments.
/// Checked by tests/stress/test_shear_path.cpp
namespace granum::stress {

/// A vertical and two equal horizontal stresses, compression positive [Pa].
struct AxialStress {
  double v = 0;
  double h = 0;

  constexpr bool operator==(const AxialStress&) const = default;
  [[nodiscard]] double mean() const { return (v + 2 * h) / 3; } ///< p'
  [[nodiscard]] double deviator() const { return v - h; }       ///< q
  /// eta = q/p'; 0 without stress.
  [[nodiscard]] double ratio() const { return v == h ? 0 : deviator() / mean(); }
};

/// Friction angle that a state of stress mobilises, arcsin of (s1 - s3)/(s1 + s3), the inverse of
/// failure_ratio.
/// \param    stress   both stresses >= 0, not both 0 [Pa]
/// \return   in [0, pi/2] [rad]
/// \throws   InvalidArgument if a stress is negative or both are 0
/// Accuracy  8 ulp.  Checked by tests/stress/test_shear_path.cpp
[[nodiscard]] double mobilised_friction_angle(const AxialStress& stress);

/// Horizontal over vertical stress that friction of 70 degrees holds, more than any soil or packing has.
inline constexpr double least_stress_ratio = 0.031091204125576, largest_stress_ratio = 1 / least_stress_ratio;

} // namespace granum::stress
