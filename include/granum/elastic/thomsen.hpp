// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/elastic/transverse_isotropic.hpp>

/// Transverse isotropy in the seismologist's notation: two speeds along the axis and three pure numbers, all
/// zero for an isotropic solid.                                               [Thomsen1986, Eqs 8a, 8b, 17]
/// Checked by tests/elastic/test_thomsen.cpp
namespace granum::elastic {

struct ThomsenParameters {
  double epsilon = 0; ///< (C11-C33)/(2 C33)
  double delta = 0;   ///< exact or weak, according to the function that made it
  double gamma = 0;   ///< (C66-C44)/(2 C44)

  bool operator==(const ThomsenParameters&) const = default;
};

/// A solid by its density, its speeds along the axis and its exact parameters.
struct ThomsenSolid {
  double bulk_density = 0;     ///< [kg/m3]
  double vertical_p_speed = 0; ///< V_p0, sqrt(C33/density) [m/s]
  double vertical_s_speed = 0; ///< V_s0, sqrt(C44/density) [m/s]
  ThomsenParameters anisotropy{};

  bool operator==(const ThomsenSolid&) const = default;
};

/// Exact parameters: delta = ((C13+C44)^2 - (C33-C44)^2)/(2 C33 (C33-C44)), half the curvature of
/// ln V_p at the axis.                                                                [Thomsen1986, Eq. 17]
/// \throws   InvalidArgument unless the stiffness is positive definite and C33 > C44
/// Accuracy  8 ulp; near isotropy too, where the factors of delta are formed without cancellation.
[[nodiscard]] ThomsenParameters thomsen_parameters(const TransverselyIsotropic& stiffness);

/// The same with delta to first order in the anisotropy, (C13 + 2 C44 - C33)/C33.       [Mensch1997, Eq. 20]
/// \throws   InvalidArgument unless the stiffness is positive definite
/// Accuracy  4 ulp.
[[nodiscard]] ThomsenParameters weak_thomsen_parameters(const TransverselyIsotropic& stiffness);

/// Speeds along the axis and exact parameters of a stiffness.
/// \param    bulk_density   mass per volume of the packing [kg/m3], > 0
/// \throws   InvalidArgument as thomsen_parameters, or for another density
/// Accuracy  8 ulp.
[[nodiscard]] ThomsenSolid thomsen_solid(const TransverselyIsotropic& stiffness, double bulk_density);

/// Stiffness of a solid given by exact parameters: the inverse of thomsen_solid.
/// Assumes   C13 + C44 >= 0. A solid with C13 + C44 < 0 shares its delta with one that has the opposite sum.
/// \param    solid   density > 0, V_p0 > V_s0 > 0
/// \throws   InvalidArgument for other speeds, or if no positive definite stiffness has these parameters
/// Accuracy  8 ulp of C33.
[[nodiscard]] TransverselyIsotropic transversely_isotropic(const ThomsenSolid& solid);

} // namespace granum::elastic
