// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/packing/assembly.hpp>

namespace granum::packing {

/// Unbalanced contact forces on grains at rest under a body force: the same force per volume on
/// each.
struct Weight {
  Vec3 per_volume{};    ///< density times gravity, along gravity [N/m3]
  double left_over = 1; ///< mean |residual force| without it over that with it, grains with a contact [1]
};

/// The common body force of all grains with a contact, by least squares of the residual forces on the
/// volumes.
/// \return   left_over = 1 where there is no residual
/// \throws   InvalidArgument for an assembly that require_valid rejects
/// Accuracy  rounding, where grains rest under such a force.  Checked by tests/packing/test_weight.cpp
[[nodiscard]] Weight common_weight(const Assembly& assembly);

} // namespace granum::packing
