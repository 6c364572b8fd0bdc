// SPDX-License-Identifier: GPL-3.0-or-later
#include <granum/effective/coordination_relations.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <granum/core/check.hpp>
#include <granum/core/error.hpp>
#include <granum/core/number.hpp>

namespace granum::effective {

namespace {

/// Rows from porosity 0.2 on in steps of 0.05. [Murphy1982]
constexpr std::array<double, 11> murphy{14.007, 12.336, 10.843, 9.5078, 8.3147, 7.2517,
                                        6.3108, 5.4878, 4.7826, 4.1988, 3.7440};

double from_table(double porosity) {
  const double place = (porosity - 0.2) / 0.05;
  const auto row = std::min(static_cast<std::size_t>(std::max(place, 0.0)), murphy.size() - 2);
  const double part = place - static_cast<double>(row);
  return (1 - part) * murphy[row] + part * murphy[row + 1];
}

} // namespace

std::string_view name(CoordinationRelation relation) {
  switch (relation) {
  case CoordinationRelation::murphy_table:
    return "murphy-table";
  case CoordinationRelation::murphy_quadratic:
    return "murphy-quadratic";
  case CoordinationRelation::garcia_medina:
    return "garcia-medina";
  }
  throw InvalidArgument("coordination relation is not one of the known ones");
}

PorosityRange range(CoordinationRelation relation) {
  switch (relation) {
  case CoordinationRelation::murphy_table:
    return {0.2, 0.7};
  case CoordinationRelation::murphy_quadratic:
    return {0.2, 0.6};
  case CoordinationRelation::garcia_medina:
    return {0.3, 0.384};
  }
  throw InvalidArgument("coordination relation is not one of the known ones");
}

double coordination_number(CoordinationRelation relation, double porosity) {
  const auto [lowest, highest] = range(relation);
  if (!(porosity >= lowest && porosity <= highest))
    throw InvalidArgument("porosity", porosity, "",
                          "[" + short_text(lowest) + ", " + short_text(highest) +
                              "], the range of the relation " + std::string(name(relation)));
  switch (relation) {
  case CoordinationRelation::murphy_table:
    return from_table(porosity);
  case CoordinationRelation::murphy_quadratic:
    return 20 - 34 * porosity + 14 * porosity * porosity;
  case CoordinationRelation::garcia_medina:
    break;
  }
  return 4.46 + 9.7 * std::pow(0.384 - porosity, 0.48);
}

double coordination_number_at_pressure(double pressure) {
  require_non_negative("pressure", pressure, "Pa");
  return 6 + std::cbrt(pressure / 0.06e6);
}

} // namespace granum::effective
