// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include <granum/core/error.hpp>
#include <granum/core/vec3.hpp>

namespace granum::elastic {

/// The unit vector along `vector`, whatever its length.
/// \throws   InvalidArgument for the zero vector or one that is not finite
inline Vec3 unit_along(const char* name, const Vec3& vector) {
  Vec3 v = vector;
  double square = dot(v, v);
  if (!(square > 1e-200 && square < 1e200)) { // squares near the ends of the range of doubles, or none at all
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z) || largest == 0)
      throw InvalidArgument(std::string(name) + " must be a finite vector other than zero");
    v = {v.x / largest, v.y / largest, v.z / largest};
    square = dot(v, v);
  }
  const double length = std::sqrt(square);
  return {v.x / length, v.y / length, v.z / length};
}

} // namespace granum::elastic
