// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <granum/core/error.hpp>
#include <granum/core/vec3.hpp>

/// One axisymmetric fabric in the notations that are in use, each made from any other.
/// Checked by tests/fabric/test_measures.cpp
namespace granum::fabric {

/// Measures of one fabric. They are moments of second order and as such exist for every set of contacts;
/// E(gamma; a) is a density only for |a| <= 1, that is F33 in [0.2, 0.6] and P2 coefficient in [-1, 2].
/// Values outside come back as they are, with a note.
struct FabricMeasures {
  double anisotropy = 0;             ///< a of E(gamma; a), in [-5, 5/3]
  double F11 = 1.0 / 3;              ///< mean of n1^2, in [0, 1/2]
  double F33 = 1.0 / 3;              ///< mean of n3^2, in [0, 1]
  double P2_coefficient = 0;         ///< a_c of E = (1 + a_c P2(cos gamma))/(4 pi), in [-5/2, 5]; at the same
                                     ///< time the 33 component of contact_tensor
  double mean_cos_2gamma = -1.0 / 3; ///< 2 F33 - 1, in [-1, 1]
  Validity validity;                 ///< a note if |a| > 1
};

/// From a: a_c = 4a/(3-a).                                                                [Chung2014, Eq. 10]
/// \throws   InvalidArgument unless a is in [-5, 5/3]: no set of unit vectors has another
/// Accuracy  a and a_c 4 ulp, the others 4 ulp of 1; so also below.
[[nodiscard]] FabricMeasures measures_from_anisotropy(double anisotropy);
/// From the mean of n3^2: a_c = 5(3 F33 - 1)/2.
/// \throws   InvalidArgument unless F33 is in [0, 1]
[[nodiscard]] FabricMeasures measures_from_F33(double F33);
/// From the coefficient of P2, or the 33 component of a contact tensor: a = 3 a_c/(4 + a_c).
/// \throws   InvalidArgument unless the coefficient is in [-5/2, 5]
[[nodiscard]] FabricMeasures measures_from_P2_coefficient(double P2_coefficient);
/// From the mean of cos 2 gamma: a = 5(1+3c)/(7+5c).
/// \throws   InvalidArgument unless the mean is in [-1, 1]
[[nodiscard]] FabricMeasures measures_from_mean_cos_2gamma(double mean_cos_2gamma);

/// Traceless contact tensor 15/2 (F - 1/3), as LAMMPS' compute fabric writes it.               [Kanatani1984]
/// \param    fabric   mean of n_i n_j, symmetric within 1e-3 of its largest entry, trace 1 within 1e-6
/// \throws   InvalidArgument for another matrix
/// Accuracy  rounding of F.
[[nodiscard]] Mat3 contact_tensor(const Mat3& fabric);
/// F = 1/3 + 2/15 A, the inverse of the above.
/// \param    contact_tensor   A, symmetric within 1e-3 of its largest entry, trace 0 within 1e-5
/// \throws   InvalidArgument for another matrix
[[nodiscard]] Mat3 fabric_from_contact_tensor(const Mat3& contact_tensor);

} // namespace granum::fabric
