// SPDX-License-Identifier: GPL-3.0-or-later
// Private to src/network.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <granum/core/vec3.hpp>

namespace granum::network {

/// Sorts points into two halves along the longest side of their bounding box; returns the number in the
/// first.
/// \param    points   numbers of points, at least 1
std::size_t halve(const std::vector<Vec3>& position, std::span<std::uint32_t> points);

} // namespace granum::network
