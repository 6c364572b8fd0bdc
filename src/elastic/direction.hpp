// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include <granum/core/error.hpp>
#include <granum/core/vec3.hpp>

namespace granum::elastic {

/// The unit vector along `vector`, whatever its length; scaled first, so that no square leaves the range of
/// doubles.
/// \throws   InvalidArgument for the zero vector or one that is not finite
inline Vec3 unit_along(const char* name, const Vec3& vector) {
  const double largest = std::max({std::abs(vector.x), std::abs(vector.y), std::abs(vector.z)});
  const bool finite = std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
  if (!finite || largest == 0)
    throw InvalidArgument(std::string(name) + " must be a finite vector other than zero");
  const Vec3 scaled{vector.x / largest, vector.y / largest, vector.z / largest};
  const double length = norm(scaled);
  return {scaled.x / length, scaled.y / length, scaled.z / length};
}

} // namespace granum::elastic
