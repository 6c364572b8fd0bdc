// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <string>

#include <granum/core/error.hpp>
#include <granum/core/stop.hpp>
#include <granum/core/vec3.hpp>

namespace granum::fabric {

/// A sufficiently large sample of contact normals, all unit vectors.
/// \throws   InvalidArgument for fewer than `fewest`, or a length that differs from 1 by more than 1e-6
inline void require_normals(std::span<const Vec3> normals, std::size_t fewest) {
  if (normals.size() < fewest)
    throw InvalidArgument("number of contact normals", static_cast<double>(normals.size()), "",
                          "[" + std::to_string(fewest) + ", inf)");
  for (std::size_t i = 0; i < normals.size(); ++i) {
    stop_point(i);
    if (const double length = norm(normals[i]); !(std::abs(length - 1) <= 1e-6))
      throw InvalidArgument("length of contact normal " + std::to_string(i), length, "", "1 +- 1e-6");
  }
}

/// n3^2 of the normal at length 1: in [0, 1] whatever the rounding of its length.
inline double squared_cosine(const Vec3& n) { return n.z * n.z / dot(n, n); }

/// Legendre polynomial of the polar cosine, (3 cos^2 - 1)/2, in [-1/2, 1].
inline double legendre_2(const Vec3& n) { return (3 * squared_cosine(n) - 1) / 2; }

} // namespace granum::fabric
