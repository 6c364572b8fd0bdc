// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/estimate/question.hpp>

#include <cmath>
#include <numbers>

#include <granum/core/error.hpp>
#include <granum/core/text.hpp>
#include <granum/estimate/inputs.hpp>
#include <granum/stress/stress.hpp>

#include "parts.hpp"

namespace granum::estimate {

std::string_view name(GrainShape shape) { return shape == GrainShape::sand ? "sand" : "sphere"; }

GrainShape grain_shape_of(std::string_view text) {
  for (const GrainShape shape : all_grain_shapes)
    if (name(shape) == text)
      return shape;
  throw InvalidArgument("grain_shape is sphere or sand, not '" + std::string(text) + "'");
}

namespace {

constexpr double degree = std::numbers::pi / 180;

/// Friction angle without which the stresses are not possible; 0 without stress.
double mobilised_friction_angle(const Question& q) {
  return q.state.stress_v > 0 ? stress::mobilised_friction_angle({q.state.stress_v, q.state.stress_h}) : 0;
}

} // namespace

void require_possible(const Question& q) {
  require_closed("saturation", q.saturation, 0, 1);
  if (q.grain_density)
    require_positive("grain_density", *q.grain_density, "kg/m3");
  if (q.grain_shape == GrainShape::sand) {
    effective::require_valid(q.state);
    return;
  }
  if (q.shear_strain)
    throw InvalidArgument(
        "shear_strain", *q.shear_strain, "",
        "what spheres have: the laws of strain are measured on sands; for spheres only small "
        "strain is available");
  if (q.sand.uniformity.value_or(1) > sphere_uniformity_limit)
    throw InvalidArgument("uniformity", *q.sand.uniformity, "",
                          "[1, 4] for spheres, the validated range; use grain shape sand");
}

void require_valid(const Question& q) {
  for (const InputRow& row : inputs())
    if (const std::optional<double> value = row.read != nullptr ? row.read(q) : std::nullopt)
      require_within(row, *value, row.name(), true); // a hint on signs is the door's
  sands::require_density(q.sand, q.state.void_ratio);
  constexpr double rounding = 1e-9;
  const double v = q.state.stress_v, least = stress::least_stress_ratio * v * (1 - rounding),
               largest = stress::largest_stress_ratio * v * (1 + rounding);
  if (v > 0 && !(q.state.stress_h >= least && q.state.stress_h <= largest))
    throw InvalidArgument("stress_h", q.state.stress_h, "Pa",
                          detail::closed_range(least, largest, q.state.stress_h) +
                              ": friction of 70 degrees holds no other beside this stress_v");
  require_possible(q);
}

void note_strength(const Question& q, Validity& validity) {
  constexpr double strongest_soil = 50 * degree;
  if (const double angle = mobilised_friction_angle(q); angle > strongest_soil)
    validity.add("stress_h is " + short_text(q.state.stress_h / q.state.stress_v) +
                 " stress_v (K_0): only a friction angle of " + short_text(angle / degree, 3) +
                 " degrees holds that, and soils have at most 50");
}

double assumed_fabric_deviation(double stress_v, double stress_h) {
  constexpr double poured = 0.05, by_shear = 0.2;
  return std::hypot(poured, stress_v > 0 && stress_h > 0 ? by_shear * std::log(stress_v / stress_h) : 0);
}

} // namespace granum::estimate
