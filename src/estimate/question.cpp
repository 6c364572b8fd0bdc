// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/estimate/question.hpp>

#include <cmath>

#include <granum/core/error.hpp>

namespace granum::estimate {

std::string_view name(GrainShape shape) { return shape == GrainShape::sand ? "sand" : "sphere"; }

GrainShape grain_shape_of(std::string_view text) {
  for (const GrainShape shape : all_grain_shapes)
    if (name(shape) == text)
      return shape;
  throw InvalidArgument("grain_shape is sphere or sand, not '" + std::string(text) + "'");
}

double assumed_fabric_deviation(double stress_v, double stress_h) {
  constexpr double poured = 0.05, by_shear = 0.2;
  return std::hypot(poured, stress_v > 0 && stress_h > 0 ? by_shear * std::log(stress_v / stress_h) : 0);
}

} // namespace granum::estimate
