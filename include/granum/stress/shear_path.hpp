// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

#include <granum/stress/axial_stress.hpp>

/// The paths of triaxial tests as algebra.
/// Checked by tests/stress/test_shear_path.cpp
namespace granum::stress {

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

} // namespace granum::stress
