// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace granum::effective {

/// Published relations of the coordination number of sphere packs with their porosity. They are averages over
/// ways of preparation: packings of one porosity can differ by a factor of 1.7 in C_n.
enum class CoordinationRelation {
  murphy_table,     ///< table, linear between its rows; porosity 0.2 to 0.7            [Murphy1982]
  murphy_quadratic, ///< 20 - 34 n + 14 n^2 through that table; 0.2 to 0.6              [Murphy1982]
  garcia_medina     ///< 4.46 + 9.7 (0.384 - n)^0.48 of simulated packings; 0.3 to 0.384 [GarciaMedina2006]
};

[[nodiscard]] std::string_view name(CoordinationRelation relation);

/// Range of porosities that a relation was made from.
struct PorosityRange {
  double lowest = 0;
  double highest = 0;
};
[[nodiscard]] PorosityRange range(CoordinationRelation relation);

/// C_n by a relation.
/// \throws   InvalidArgument outside the relation's range, naming it
/// Accuracy  4 ulp of the printed formula.  Checked by tests/effective/test_coordination_relations.cpp
[[nodiscard]] double coordination_number(CoordinationRelation relation, double porosity);

/// C_n = 6 + (p/0.06 MPa)^(1/3), simulated packings of glass spheres made without friction. [Makse1999]
/// \param    pressure   p >= 0 [Pa]
/// \throws   InvalidArgument if the pressure is negative or not finite
/// Accuracy  4 ulp.  Checked by tests/effective/test_coordination_relations.cpp
[[nodiscard]] double coordination_number_at_pressure(double pressure);

} // namespace granum::effective
