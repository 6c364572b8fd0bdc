// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/core/vec3.hpp>

namespace granum::packing {

/// Volume of the unit ball about the origin that lies in the box from low to high, low <= high.
/// Accuracy  1e-10: closed form where one axis cuts it, Gauss quadrature of closed-form sections elsewhere.
///           Checked by tests/packing/test_interior.cpp
[[nodiscard]] double unit_sphere_in_box(Vec3 low, Vec3 high);

} // namespace granum::packing
