// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/rock_physics/coordination_relations.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include <granum/core/error.hpp>

namespace granum::rock_physics {

namespace {

/// C_n at porosities 0.20, 0.25, ..., 0.70.
constexpr std::array<double, 11> murphy{14.007, 12.336, 10.843, 9.5078, 8.3147, 7.2517,
                                        6.3108, 5.4878, 4.7826, 4.1988, 3.7440};

double from_table(double porosity) {
  const double place = (porosity - 0.2) / 0.05;
  const std::size_t i = std::min(static_cast<std::size_t>(place), murphy.size() - 2);
  const double t = place - static_cast<double>(i);
  return (1 - t) * murphy[i] + t * murphy[i + 1];
}

} // namespace

PorosityRange porosity_range(CoordinationRelation relation) {
  switch (relation) {
  case CoordinationRelation::murphy_table:
  case CoordinationRelation::murphy_quadratic:
  case CoordinationRelation::murphy_exponential:
    return {.low = 0.2, .high = 0.7};
  }
  throw InvalidArgument(
      "coordination relation must be one of murphy_table, murphy_quadratic, murphy_exponential");
}

double coordination_number(double porosity, CoordinationRelation relation) {
  const PorosityRange range = porosity_range(relation);
  require_closed("porosity", porosity, range.low, range.high);
  switch (relation) {
  case CoordinationRelation::murphy_quadratic:
    return (20 - 14 * porosity) * (1 - porosity); // factors keep the digits that the sum would lose
  case CoordinationRelation::murphy_exponential:
    return 24 * std::exp(-2.547 * porosity) - 0.3731;
  default:
    return from_table(porosity);
  }
}

} // namespace granum::rock_physics
