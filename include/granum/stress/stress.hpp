// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string_view>

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

/// \file
/// The paths of triaxial tests as algebra.
/// Checked by tests/stress/test_shear_path.cpp

/// Tests that start from an isotropic stress and change one of the two stresses.            [Chung2014]
enum class ShearPath {
  txc,  ///< triaxial compression: vertical stress grows, horizontal constant
  rtxc, ///< reduced triaxial compression: horizontal stress falls, vertical constant
  rtxe, ///< reduced triaxial extension: vertical stress falls, horizontal constant
  txe,  ///< triaxial extension: horizontal stress grows, vertical constant
};

inline constexpr std::array all_shear_paths{ShearPath::txc, ShearPath::rtxc, ShearPath::rtxe, ShearPath::txe};

/// "TXC", "RTXC", "RTXE", "TXE".
[[nodiscard]] std::string_view name(ShearPath path);

/// Whether eta grows from 0 on this path (compression) or falls (extension).
[[nodiscard]] bool is_compression(ShearPath path);

/// The stress at which a path reaches a stress ratio. The constant stress of the path is `start` to
/// the bit.                                                                                   [Chung2014]
/// \param    start   mean stress > 0 where the path begins, isotropic [Pa]
/// \param    eta     q/p', in [0, 3) in compression, in (-3/2, 0] in extension, where the lower stress is 0
/// \throws   InvalidArgument if start or eta is out of its range
/// Accuracy  8 ulp away from the open end.  Checked by tests/stress/test_shear_path.cpp
[[nodiscard]] AxialStress stress_on_path(ShearPath path, double start, double eta);

/// eta at failure of a cohesionless material on a path: 6 sin/(3 - sin) in compression, -6 sin/(3 + sin) in
/// extension, from sin = (s1 - s3)/(s1 + s3).
/// \param    friction_angle   of the material, in (0, pi/2) [rad]
/// \throws   InvalidArgument if the angle is out of its range
/// Accuracy  8 ulp.  Checked by tests/stress/test_shear_path.cpp
[[nodiscard]] double failure_ratio(ShearPath path, double friction_angle);

/// \file
/// Stresses in level ground: total, pore pressure, and effective.
/// Checked by tests/stress/test_ground.cpp

/// Level ground with two unit weights, above and below the water table, and a load on it.
struct Ground {
  double unit_weight = 0;           ///< above the water table, with its water, >= 0 [N/m3]
  double saturated_unit_weight = 0; ///< below it, of grains and water together, >= water_unit_weight [N/m3]
  /// Depth of the water table [m]; none: the ground is dry. Negative: height of water above the ground.
  std::optional<double> water_table = std::nullopt;
  double water_unit_weight = 0; ///< > 0 [N/m3]
  /// K_0, horizontal over vertical effective stress, from least_stress_ratio to largest_stress_ratio [1].
  double earth_pressure_at_rest = 1;
  double surcharge = 0; ///< on the surface, >= 0 [Pa]
};

/// Compression positive [Pa].
struct GroundStress {
  AxialStress total;        ///< of grains and water together
  double pore_pressure = 0; ///< u
  AxialStress effective;    ///< carried by the grains: total - u in both directions
};

/// Stresses at a depth: sigma_v is the weight above and the surcharge, u is hydrostatic below the water table
/// and 0 above it, sigma'_v = sigma_v - u, sigma'_h = K_0 sigma'_v, sigma_h = sigma'_h + u.
/// Assumes   level ground at rest, one K_0 at all depths, water at rest, no suction above its table.
/// \param    depth   below the surface, >= 0 [m]
/// \throws   InvalidArgument naming the member or the depth that is out of its range
/// Accuracy  8 ulp of the largest term.  Checked by tests/stress/test_ground.cpp
[[nodiscard]] GroundStress stress_at(const Ground& ground, double depth);

} // namespace granum::stress
