// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace granum::rock_physics {

/// Published relations between coordination number and porosity, all from Murphy's compilation [Murphy1982];
/// the exponential is given in [Zimmer2007].
enum class CoordinationRelation {
  murphy_table,       ///< eleven points from 14.007 at 0.2 to 3.744 at 0.7, linear in between
  murphy_quadratic,   ///< 20 - 34 phi + 14 phi^2
  murphy_exponential, ///< 24 exp(-2.547 phi) - 0.3731
};

/// Porosities that a relation was made for.
struct PorosityRange {
  double low = 0;
  double high = 0;
};
/// \throws   InvalidArgument for a value that is no CoordinationRelation
[[nodiscard]] PorosityRange porosity_range(CoordinationRelation relation);

/// C_n of clean, well sorted grains at a porosity. The relations differ by up to 0.7 from each other: none of
/// them replaces a measured coordination number, and none knows how the packing was made.       [Murphy1982]
/// \param    porosity   in porosity_range(relation), [0.2, 0.7]; no extrapolation
/// \throws   InvalidArgument for a porosity out of that range
/// Accuracy  4 ulp of the relation.  Checked by tests/rock_physics/test_coordination_relations.cpp
[[nodiscard]] double coordination_number(double porosity, CoordinationRelation relation);

} // namespace granum::rock_physics
