// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/assembly.
#pragma once

#include <granum/core/vec3.hpp>

namespace granum {

/// Volume of the unit ball about the origin that lies in the box from low to high, low <= high.
/// Accuracy  1e-10: closed form where one axis cuts it, Gauss quadrature of closed-form sections elsewhere.
///           Checked by tests/assembly/test_interior.cpp
[[nodiscard]] double unit_sphere_in_box(Vec3 low, Vec3 high);

} // namespace granum
